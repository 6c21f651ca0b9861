#include "reports/fit/concordance_report.hpp"

#include "reports/fit/cells.hpp"
#include "reports/fit/interval_columns.hpp"

namespace tcert {
namespace {

Table estimate_table(const statistics::ConcordanceResult& result, double level) {
  Table table;
  table.name = "concordance";
  table.title = "Concordance C: Pr(the row with the longer time has the better value)";
  table.n = static_cast<std::int64_t>(result.n);
  table.columns = {text_column("term", "predictor"),
                   number_column("estimate", "C"),
                   number_column("std.error", "SE"),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high"),
                   number_column("variance", "variance"),
                   number_column("null.variance", "variance at 1/2"),
                   number_column("concordant", "concordant"),
                   number_column("discordant", "discordant"),
                   number_column("tied.x", "tied x"),
                   number_column("tied.y", "tied y"),
                   number_column("tied.xy", "tied xy")};
  for (std::size_t k = table.columns.size() - 5; k < table.columns.size(); ++k) {
    table.columns[k].significant = 12;
  }
  if (result.clusters > 0) {
    append_columns(t_columns(false), table.columns);
    table.footnotes.push_back(t_footnote(result.clusters));
  }
  for (const statistics::ConcordanceEstimate& one : result.estimates) {
    std::vector<TableCell> cells{one.name,
                                 number_cell(one.c),
                                 number_cell(one.std_error),
                                 low_cell(one.interval),
                                 high_cell(one.interval),
                                 number_cell(one.variance),
                                 number_cell(one.null_variance),
                                 number_cell(one.counts.concordant),
                                 number_cell(one.counts.discordant),
                                 number_cell(one.counts.tied_x),
                                 number_cell(one.counts.tied_y),
                                 number_cell(one.counts.tied_xy)};
    if (result.clusters > 0) {
      append_t(clipped(statistics::by_cluster_t(one.c, one.std_error, {}, result.clusters, level)),
               cells,
               false);
    }
    table.add_row(std::move(cells));
  }
  return table;
}

Table difference_table(const statistics::ConcordanceResult& result, double level) {
  Table table;
  table.name = "differences";
  table.title = "Paired differences of C";
  table.columns = {text_column("first", "first"),
                   text_column("second", "second"),
                   number_column("estimate", "difference"),
                   number_column("std.error", "SE"),
                   number_column("statistic", "z"),
                   p_column(),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high")};
  if (result.clusters > 0) {
    append_columns(t_columns(), table.columns);
  }
  for (const statistics::ConcordanceDifference& one : result.differences) {
    std::vector<TableCell> cells{result.estimates[one.first].name,
                                 result.estimates[one.second].name,
                                 number_cell(one.difference),
                                 number_cell(one.std_error),
                                 number_cell(one.z),
                                 p_cell(one.p_value),
                                 low_cell(one.interval),
                                 high_cell(one.interval)};
    if (result.clusters > 0) {
      append_t(
          statistics::by_cluster_t(one.difference, one.std_error, one.z, result.clusters, level),
          cells);
    }
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace

FitReport concordance_report(const statistics::ConcordanceResult& result, double level) {
  FitReport report;
  report.model = "concordance";
  report.tables = {estimate_table(result, level)};
  if (!result.differences.empty()) {
    report.tables.push_back(difference_table(result, level));
  }
  Record summary("summary", "Rows");
  summary.integer("n", "rows", result.n)
      .integer("nevent", "events", result.events)
      .integer("clusters", "clusters", result.clusters)
      .integer("missing", "rows without a predictor", result.missing);
  report.summary = std::move(summary).table();
  std::vector<std::string> names;
  for (const statistics::ConcordanceEstimate& one : result.estimates) {
    names.push_back(one.name);
    report.conditions.insert(report.conditions.end(), one.conditions.begin(), one.conditions.end());
  }
  report.conditions.insert(
      report.conditions.begin(), result.conditions.begin(), result.conditions.end());
  for (const statistics::ConcordanceDifference& one : result.differences) {
    report.conditions.insert(report.conditions.end(), one.conditions.begin(), one.conditions.end());
  }
  point_to_t(report.conditions);
  if (result.covariance.rows() == static_cast<Eigen::Index>(names.size())) {
    report.details.push_back(
        matrix_table("vcov", "Covariance of the concordances", names, result.covariance));
  }
  return report;
}

}  // namespace tcert
