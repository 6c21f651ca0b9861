#include "reports/fit/roc_report.hpp"

#include <cmath>

#include "reports/fit/interval_columns.hpp"
#include "reports/fit/matrix_table.hpp"

namespace tcert {
namespace {

std::optional<double> root(const std::optional<double>& variance) {
  return variance ? std::optional(std::sqrt(*variance)) : std::nullopt;
}

struct Marker : RowOf<statistics::AucEstimate> {
  std::string name;
  std::optional<statistics::PartialAuc> partial;
};

Table auc_table(const std::vector<std::string>& names,
                const statistics::JointAuc& joint,
                const std::vector<statistics::RocCurve>& curves,
                const std::optional<PartialRange>& partial) {
  using statistics::AucEstimate;
  const AucEstimate& first = joint.markers.front();
  ColumnsOf<Marker> columns;
  columns.text("term", "predictor", &Marker::name)
      .number("estimate", "AUC", &AucEstimate::auc)
      .number("std.error", "SE", [](auto& r) { return root(r.of.variance); })
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &AucEstimate::interval)
      .number("variance", "variance", &AucEstimate::variance);
  if (first.clusters > 0) {
    columns.part(t_columns(false), [&](auto& r) {
      return std::optional(clipped(
          statistics::by_cluster_t(r.of.auc, root(r.of.variance), {}, r.of.clusters, joint.level)));
    });
  }
  if (partial) {
    using statistics::PartialAuc;
    columns.part(ColumnsOf<PartialAuc>()
                     .number("partial.area", "partial area", &PartialAuc::area)
                     .number("partial.corrected", "corrected", &PartialAuc::corrected),
                 &Marker::partial);
  }
  Table table = columns.table("auc", "AUC: Pr(a success has the larger value), ties one half");
  table.n = static_cast<std::int64_t>(first.successes + first.failures);
  for (std::size_t k = 0; k < names.size(); ++k) {
    Marker row{{joint.markers[k]}, names[k], {}};
    if (partial) {
      row.partial = statistics::partial_auc(curves[k], partial->low, partial->high, partial->focus);
    }
    table.add_row(columns.row(row));
  }
  if (first.clusters > 0) {
    table.footnotes.push_back(t_footnote(first.clusters));
  }
  return table;
}

/// Of every pair; their conditions go to the report.
std::vector<Difference> differences_of(const std::vector<std::string>& names,
                                       const statistics::JointAuc& joint,
                                       statistics::Conditions& conditions) {
  std::vector<Difference> differences;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i + 1; j < names.size(); ++j) {
      const statistics::AucDifference one = statistics::auc_contrast(joint, i, j);
      differences.push_back({names[i],
                             names[j],
                             one.difference,
                             root(one.variance),
                             one.z,
                             one.p_value,
                             one.interval});
      for (statistics::Condition condition : one.conditions) {
        if (condition.kind == statistics::ConditionKind::same_ranking ||
            condition.kind == statistics::ConditionKind::zero_variance) {
          condition.column = names[i] + ", " + names[j];
          conditions.push_back(std::move(condition));
        }
      }
    }
  }
  return differences;
}

/// A point of a predictor's curve, or a threshold on it.
template <class Of>
struct Named : RowOf<Of> {
  std::string name;
  std::string best_by = {};
};

ColumnsOf<statistics::RocPoint> point_columns() {
  using Point = statistics::RocPoint;
  return ColumnsOf<Point>()
      .number("threshold", "threshold", &Point::threshold)
      .number("sensitivity", "sensitivity", &Point::sensitivity)
      .number("specificity", "specificity", &Point::specificity);
}

Table threshold_table(const std::vector<std::string>& names,
                      const std::vector<statistics::RocCurve>& curves) {
  using Threshold = statistics::RocThreshold;
  using Row = Named<Threshold>;
  const auto columns = ColumnsOf<Row>()
                           .text("term", "predictor", &Row::name)
                           .text("best", "best by", &Row::best_by)
                           .part(point_columns(), [](auto& r) { return &r.of.point; })
                           .number("accuracy", "accuracy", &Threshold::accuracy)
                           .number("ppv", "PPV", &Threshold::ppv)
                           .number("npv", "NPV", &Threshold::npv);
  Table table =
      columns.table("thresholds", "Best thresholds, chosen and measured on the same rows");
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const auto& [criterion, word] :
         {std::pair(statistics::BestBy::youden, "youden"),
          std::pair(statistics::BestBy::closest_topleft, "closest.topleft")}) {
      for (const Threshold& best : statistics::best_thresholds(curves[k], criterion)) {
        table.add_row(columns.row({{best}, names[k], word}));
      }
    }
  }
  return table;
}

Table point_table(const std::vector<std::string>& names,
                  const std::vector<statistics::RocCurve>& curves) {
  using Row = Named<statistics::RocPoint>;
  const auto columns =
      ColumnsOf<Row>().text("term", "predictor", &Row::name).part(point_columns(), [](auto& r) {
        return &r.of;
      });
  Table table = columns.table("points", "ROC curve");
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const statistics::RocPoint& point : curves[k].points) {
      table.add_row(columns.row({{point}, names[k]}));
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
    report.tables.push_back(difference_table("Paired differences of AUC",
                                             differences_of(names, joint, report.conditions),
                                             joint.markers.front().clusters,
                                             joint.level));
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
