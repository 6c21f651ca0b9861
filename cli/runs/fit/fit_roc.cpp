#include <statistics/roc/auc_statistic.hpp>
#include <statistics/roc/roc.hpp>
#include <statistics/roc/roc_curve.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/fit/bootstrap_of_rows.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/roc_report.hpp"

namespace tcert::cli {
namespace {

/// "specificity:0.9:1".
PartialRange partial_range(const std::string& text) {
  const auto first = text.find(':');
  const auto second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) {
    throw UsageError("--partial: found '" + text + "', expected AXIS:LOW:HIGH");
  }
  PartialRange range;
  range.focus = choice("partial", text.substr(0, first), {"specificity", "sensitivity"}) == 0
                    ? statistics::RocFocus::specificity
                    : statistics::RocFocus::sensitivity;
  const std::vector<double> ends = numbers_of(
      "partial", text.substr(first + 1, second - first - 1) + ',' + text.substr(second + 1));
  if (ends.size() != 2 || !(ends[0] >= 0.0 && ends[0] < ends[1] && ends[1] <= 1.0)) {
    throw UsageError("--partial: found '" + text + "', expected 0 <= LOW < HIGH <= 1");
  }
  range.low = ends[0];
  range.high = ends[1];
  return range;
}

}  // namespace

FitReport fit_roc(const FitInput& from) {
  statistics::ModelFrame frame = from.frame;
  statistics::require_binary(frame);
  if (statistics::has_error(frame.conditions)) {
    FitReport report;
    report.model = "roc";
    report.summary.name = "summary";
    report.summary.title = "Rows";
    report.conditions = frame.conditions;
    return report;
  }
  const std::vector<double>& success = std::get<statistics::CountOutcome>(frame.outcome).successes;
  const FrameColumns columns = predictor_columns(frame);
  std::vector<statistics::Score> scores;
  for (const std::vector<double>& values : columns.values) {
    scores.push_back({values, statistics::HigherMeans::success});
  }
  statistics::AucOptions options;
  options.level = from.request.level;
  if (frame.cluster) {
    options.cluster = frame.cluster->codes;
  }
  std::vector<statistics::RocCurve> curves;
  curves.reserve(scores.size());
  for (const statistics::Score& score : scores) {
    curves.push_back(statistics::roc_curve(score.values, success, score.higher));
  }
  std::optional<PartialRange> partial;
  if (!from.request.partial.empty()) {
    partial = partial_range(from.request.partial);
  }
  FitReport report =
      roc_report(columns.names, statistics::joint_auc(scores, success, options), curves, partial);
  if (from.request.replicates > 0 && !statistics::has_error(report.conditions)) {
    require_plain_bootstrap(from, true);
    const std::vector<std::uint8_t> outcome(success.begin(), success.end());
    add_bootstrap(from, columns.names, statistics::auc_statistic(scores, outcome), report);
  }
  return report;
}

}  // namespace tcert::cli
