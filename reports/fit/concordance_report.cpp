#include "reports/fit/concordance_report.hpp"

#include "reports/fit/cells.hpp"
#include "reports/fit/interval_columns.hpp"
#include "reports/fit/matrix_table.hpp"

namespace tcert {
namespace {

Table estimate_table(const statistics::ConcordanceResult& result, double level) {
  using Estimate = statistics::ConcordanceEstimate;
  constexpr int kCountDigits = 12;
  ColumnsOf<Estimate> columns;
  columns.text("term", "predictor", &Estimate::name)
      .number("estimate", "C", &Estimate::c)
      .number("std.error", "SE", &Estimate::std_error)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &Estimate::interval)
      .number("variance", "variance", &Estimate::variance)
      .number("null.variance", "variance at 1/2", &Estimate::null_variance)
      .number("concordant", "concordant", [](auto& one) { return one.counts.concordant; })
      .significant(kCountDigits)
      .number("discordant", "discordant", [](auto& one) { return one.counts.discordant; })
      .significant(kCountDigits)
      .number("tied.x", "tied x", [](auto& one) { return one.counts.tied_x; })
      .significant(kCountDigits)
      .number("tied.y", "tied y", [](auto& one) { return one.counts.tied_y; })
      .significant(kCountDigits)
      .number("tied.xy", "tied xy", [](auto& one) { return one.counts.tied_xy; })
      .significant(kCountDigits);
  if (result.clusters > 0) {
    columns.part(t_columns(false), [&](auto& one) {
      return std::optional(
          clipped(statistics::by_cluster_t(one.c, one.std_error, {}, result.clusters, level)));
    });
  }
  Table table =
      columns.table("concordance",
                    "Concordance C: Pr(the row with the longer time has the better value)",
                    result.estimates);
  table.n = static_cast<std::int64_t>(result.n);
  if (result.clusters > 0) {
    table.footnotes.push_back(t_footnote(result.clusters));
  }
  return table;
}

std::vector<Difference> differences_of(const statistics::ConcordanceResult& result) {
  std::vector<Difference> differences;
  for (const statistics::ConcordanceDifference& one : result.differences) {
    differences.push_back({result.estimates[one.first].name,
                           result.estimates[one.second].name,
                           one.difference,
                           one.std_error,
                           one.z,
                           one.p_value,
                           one.interval});
  }
  return differences;
}

}  // namespace

FitReport concordance_report(const statistics::ConcordanceResult& result, double level) {
  FitReport report;
  report.model = "concordance";
  report.tables = {estimate_table(result, level)};
  if (!result.differences.empty()) {
    report.tables.push_back(difference_table(
        "Paired differences of C", differences_of(result), result.clusters, level));
  }
  Record summary("summary", "Rows");
  summary.integer("n", "rows", result.n)
      .integer("nevent", "events", result.events)
      .integer("clusters", "clusters", result.clusters)
      .integer("missing", "rows without a predictor", result.missing);
  report.summary = std::move(summary).table();
  report.conditions = result.conditions;
  std::vector<std::string> names;
  for (const statistics::ConcordanceEstimate& one : result.estimates) {
    names.push_back(one.name);
    report.add(one.conditions);
  }
  for (const statistics::ConcordanceDifference& one : result.differences) {
    report.add(one.conditions);
  }
  point_to_t(report.conditions);
  if (result.covariance.rows() == static_cast<Eigen::Index>(names.size())) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the concordances", names, result.covariance));
  }
  return report;
}

}  // namespace tcert
