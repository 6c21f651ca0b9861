#include "cli/runs/fit/bootstrap_of_rows.hpp"

#include <statistics/resampling/bootstrap_difference.hpp>

#include "cli/runs/errors.hpp"
#include "reports/fit/bootstrap_table.hpp"

namespace tcert::cli {

FrameColumns predictor_columns(const statistics::ModelFrame& frame) {
  FrameColumns columns;
  for (std::size_t k = 0; k < frame.columns.size(); ++k) {
    if (frame.term_of[k] == 0) {
      continue;
    }
    const auto column = frame.design.col(static_cast<Eigen::Index>(k));
    columns.names.push_back(frame.columns[k]);
    columns.values.emplace_back(column.data(), column.data() + column.size());
  }
  if (columns.names.empty()) {
    throw statistics::FormulaError("formula '" + frame.formula + "': names no predictor");
  }
  return columns;
}

void require_plain_bootstrap(const FitInput& from, bool plain) {
  if (from.frame.weights || !plain) {
    throw UsageError("--bootstrap draws rows: leave out --weights and --pair-weight");
  }
}

void add_bootstrap(const FitInput& from,
                   const std::vector<std::string>& names,
                   const statistics::Statistic& statistic,
                   FitReport& report) {
  const auto& cluster = from.frame.cluster;
  const statistics::ResamplingPlan plan =
      cluster ? statistics::ResamplingPlan::of_clusters(cluster->codes)
              : statistics::ResamplingPlan::of_rows(from.frame.size());
  statistics::BootstrapOptions options;
  options.replicates = static_cast<std::size_t>(from.request.replicates);
  options.seed = static_cast<std::uint64_t>(from.request.seed);
  const statistics::BootstrapResult result = statistics::bootstrap(statistic, plan, options);
  BootstrapTable table(from.request.level);
  for (std::size_t k = 0; k < names.size(); ++k) {
    table.add(names[k], result, k);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i + 1; j < names.size(); ++j) {
      table.add(
          names[i] + " - " + names[j], statistics::paired_difference(result, plan, {i}, {j}), 0);
    }
  }
  table.append_to(report);
}

}  // namespace tcert::cli
