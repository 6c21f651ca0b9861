#include "cli/runs/fit/cluster_options.hpp"

#include <array>

#include "cli/runs/errors.hpp"
#include "reports/fit/left_out_table.hpp"

namespace tcert::cli {

std::optional<statistics::ClusterInference> inference_of(const FitInput& from, bool has_clusters) {
  using statistics::ClusterInference;
  const FitRequest& request = from.request;
  if (!has_clusters && (request.left_out || !request.inference.empty())) {
    throw UsageError(std::string(request.left_out ? "--left-out" : "--inference") +
                     ": needs clusters; name their column by --cluster");
  }
  if (request.inference.empty()) {
    return std::nullopt;
  }
  constexpr std::array kAll{ClusterInference::jackknife,
                            ClusterInference::cr1,
                            ClusterInference::cr2,
                            ClusterInference::wild};
  std::vector<std::string> words;
  for (const ClusterInference one : kAll) {
    words.emplace_back(to_string(one));
  }
  return kAll[choice("inference", request.inference, words)];
}

statistics::WildOptions wild_options(const FitRequest& request) {
  statistics::WildOptions options;
  options.seed = static_cast<std::uint64_t>(request.seed);
  options.level = request.level;
  return options;
}

void add_too_many_clusters(const std::optional<table::Factor>& cluster,
                           statistics::Conditions& conditions) {
  if (cluster) {
    if (auto condition = statistics::too_much_to_leave_out(statistics::count_codes(cluster->codes),
                                                           cluster->rows())) {
      conditions.push_back(std::move(*condition));
    }
  }
}

void add_cluster_tables(const FitInput& from,
                        const statistics::ClusterInferences& inferences,
                        const std::optional<statistics::ClusteredFit>& fit,
                        const std::vector<std::string>& names,
                        const table::Factor& cluster,
                        FitReport& report) {
  report.conditions.insert(
      report.conditions.end(), inferences.conditions.begin(), inferences.conditions.end());
  if (from.request.left_out && fit) {
    report.tables.push_back(
        left_out_table(names,
                       cluster,
                       fit->parts.estimates,
                       inferences.left_out ? inferences.left_out->values : fit->left_out().values));
  }
}

}  // namespace tcert::cli
