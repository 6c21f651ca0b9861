#include "reports/fit/roc_report.hpp"

#include <cmath>

#include "reports/fit/cells.hpp"
#include "reports/fit/interval_columns.hpp"

namespace tcert {
namespace {

std::optional<double> root(const std::optional<double>& variance) {
  return variance ? std::optional(std::sqrt(*variance)) : std::nullopt;
}

bool is_clustered(const statistics::JointAuc& joint) { return joint.markers.front().clusters > 0; }

Table auc_table(const std::vector<std::string>& names,
                const statistics::JointAuc& joint,
                const std::vector<statistics::RocCurve>& curves,
                const std::optional<PartialRange>& partial) {
  Table table;
  table.name = "auc";
  table.title = "AUC: Pr(a success has the larger value), ties one half";
  table.n =
      static_cast<std::int64_t>(joint.markers.front().successes + joint.markers.front().failures);
  table.columns = {text_column("term", "predictor"),
                   number_column("estimate", "AUC"),
                   number_column("std.error", "SE"),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high"),
                   number_column("variance", "variance")};
  if (is_clustered(joint)) {
    append_columns(t_columns(false), table.columns);
    table.footnotes.push_back(t_footnote(joint.markers.front().clusters));
  }
  if (partial) {
    table.columns.push_back(number_column("partial.area", "partial area"));
    table.columns.push_back(number_column("partial.corrected", "corrected"));
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    const statistics::AucEstimate& one = joint.markers[k];
    std::vector<TableCell> cells{names[k],
                                 number_cell(one.auc),
                                 number_cell(root(one.variance)),
                                 low_cell(one.interval),
                                 high_cell(one.interval),
                                 number_cell(one.variance)};
    if (is_clustered(joint)) {
      append_t(clipped(statistics::by_cluster_t(
                   one.auc, root(one.variance), {}, one.clusters, joint.level)),
               cells,
               false);
    }
    if (partial) {
      const statistics::PartialAuc area =
          statistics::partial_auc(curves[k], partial->low, partial->high, partial->focus);
      cells.push_back(number_cell(area.area));
      cells.push_back(number_cell(area.corrected));
    }
    table.add_row(std::move(cells));
  }
  return table;
}

/// Every pair; its conditions go to the report.
Table difference_table(const std::vector<std::string>& names,
                       const statistics::JointAuc& joint,
                       statistics::Conditions& conditions) {
  Table table;
  table.name = "differences";
  table.title = "Paired differences of AUC";
  table.columns = {text_column("first", "first"),
                   text_column("second", "second"),
                   number_column("estimate", "difference"),
                   number_column("std.error", "SE"),
                   number_column("statistic", "z"),
                   p_column(),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high")};
  if (is_clustered(joint)) {
    append_columns(t_columns(), table.columns);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i + 1; j < names.size(); ++j) {
      const statistics::AucDifference one = statistics::auc_contrast(joint, i, j);
      std::vector<TableCell> cells{names[i],
                                   names[j],
                                   number_cell(one.difference),
                                   number_cell(root(one.variance)),
                                   number_cell(one.z),
                                   p_cell(one.p_value),
                                   low_cell(one.interval),
                                   high_cell(one.interval)};
      if (is_clustered(joint)) {
        append_t(statistics::by_cluster_t(
                     one.difference, root(one.variance), one.z, one.clusters, joint.level),
                 cells);
      }
      table.add_row(std::move(cells));
      for (statistics::Condition condition : one.conditions) {
        if (condition.kind == statistics::ConditionKind::same_ranking ||
            condition.kind == statistics::ConditionKind::zero_variance) {
          condition.column = names[i] + ", " + names[j];
          conditions.push_back(std::move(condition));
        }
      }
    }
  }
  return table;
}

Table threshold_table(const std::vector<std::string>& names,
                      const std::vector<statistics::RocCurve>& curves) {
  Table table;
  table.name = "thresholds";
  table.title = "Best thresholds, chosen and measured on the same rows";
  table.columns = {text_column("term", "predictor"),
                   text_column("best", "best by"),
                   number_column("threshold", "threshold"),
                   number_column("sensitivity", "sensitivity"),
                   number_column("specificity", "specificity"),
                   number_column("accuracy", "accuracy"),
                   number_column("ppv", "PPV"),
                   number_column("npv", "NPV")};
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const statistics::BestBy criterion :
         {statistics::BestBy::youden, statistics::BestBy::closest_topleft}) {
      const std::string word =
          criterion == statistics::BestBy::youden ? "youden" : "closest.topleft";
      for (const statistics::RocThreshold& best :
           statistics::best_thresholds(curves[k], criterion)) {
        table.add_row({names[k],
                       word,
                       number_cell(best.point.threshold),
                       number_cell(best.point.sensitivity),
                       number_cell(best.point.specificity),
                       number_cell(best.accuracy),
                       number_cell(best.ppv),
                       number_cell(best.npv)});
      }
    }
  }
  return table;
}

Table point_table(const std::vector<std::string>& names,
                  const std::vector<statistics::RocCurve>& curves) {
  Table table;
  table.name = "points";
  table.title = "ROC curve";
  table.columns = {text_column("term", "predictor"),
                   number_column("threshold", "threshold"),
                   number_column("sensitivity", "sensitivity"),
                   number_column("specificity", "specificity")};
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const statistics::RocPoint& point : curves[k].points) {
      table.add_row({names[k],
                     number_cell(point.threshold),
                     number_cell(point.sensitivity),
                     number_cell(point.specificity)});
    }
  }
  return table;
}

}  // namespace

FitReport roc_report(const std::vector<std::string>& names,
                     const statistics::JointAuc& joint,
                     const std::vector<statistics::RocCurve>& curves,
                     const std::optional<PartialRange>& partial) {
  FitReport report;
  report.model = "roc";
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (statistics::Condition condition : joint.markers[k].conditions) {
      const bool of_marker = condition.kind == statistics::ConditionKind::all_tied ||
                             condition.kind == statistics::ConditionKind::separated;
      if (of_marker || k == 0) {
        condition.column = of_marker ? names[k] : condition.column;
        report.conditions.push_back(std::move(condition));
      }
    }
  }
  report.tables = {auc_table(names, joint, curves, partial)};
  if (names.size() > 1) {
    report.tables.push_back(difference_table(names, joint, report.conditions));
  }
  report.tables.push_back(threshold_table(names, curves));
  point_to_t(report.conditions);
  const statistics::AucEstimate& first = joint.markers.front();
  Record summary("summary", "Rows");
  summary.integer("nobs", "rows", first.successes + first.failures)
      .integer("successes", "successes", first.successes)
      .integer("failures", "failures", first.failures)
      .integer("clusters", "clusters", first.clusters);
  report.summary = std::move(summary).table();
  if (joint.covariance) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the AUCs", names, *joint.covariance));
  }
  report.details.push_back(point_table(names, curves));
  return report;
}

}  // namespace tcert
