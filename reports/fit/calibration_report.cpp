#include "reports/fit/calibration_report.hpp"

#include "reports/fit/cells.hpp"
#include "reports/fit/interval_columns.hpp"

namespace tcert {
namespace {

Table coefficient_table(const statistics::ModelCalibration& calibration, double level) {
  Table table;
  table.name = "calibration";
  table.title = "Calibration of predicted probabilities";
  table.n = static_cast<std::int64_t>(calibration.rows);
  table.columns = {text_column("term", "quantity"),
                   number_column("estimate", "estimate"),
                   number_column("std.error", "SE"),
                   number_column("conf.low", "low"),
                   number_column("conf.high", "high")};
  const bool clustered = calibration.clusters > 0;
  if (clustered) {
    append_columns(t_columns(false), table.columns);
  }
  table.columns.push_back(number_column("ideal", "ideal"));
  const auto add =
      [&](const char* name, const statistics::CalibrationCoefficient& one, double ideal) {
        std::vector<TableCell> cells{std::string(name),
                                     number_cell(one.estimate),
                                     number_cell(one.standard_error),
                                     low_cell(one.interval),
                                     high_cell(one.interval)};
        if (clustered) {
          append_t(statistics::by_cluster_t(
                       one.estimate, one.standard_error, {}, calibration.clusters, level),
                   cells,
                   false);
        }
        cells.push_back(number_cell(ideal));
        table.add_row(std::move(cells));
      };
  add("slope", calibration.slope, 1.0);
  add("intercept", calibration.intercept, 0.0);
  add("intercept, slope 1", calibration.in_the_large, 0.0);
  table.footnotes = {
      "Slope and intercept: outcome on logit p, logistic. Below 1 the probabilities are too "
      "extreme; "
      "an intercept above 0 with slope 1 says that they are too low on average.",
      calibration.clusters > 0
          ? "Errors are cluster-robust; intervals of the bins and the Hosmer-Lemeshow test take "
            "trials as independent, so with clusters they are too sure of themselves."
          : "Trials are taken as independent."};
  if (clustered) {
    table.footnotes.push_back(t_footnote(calibration.clusters));
  }
  return table;
}

Table bin_table(const statistics::ModelCalibration& calibration) {
  Table table;
  table.name = "bins";
  table.title = "Observed by predicted: bins of equal size";
  table.n = static_cast<std::int64_t>(calibration.rows);
  table.columns = {number_column("p.low", "above"),
                   number_column("p.high", "to"),
                   integer_column("n", "n"),
                   integer_column("events", "events"),
                   integer_column("clusters", "clusters"),
                   number_column("predicted", "predicted"),
                   number_column("observed", "observed"),
                   number_column("conf.low", "Wilson low"),
                   number_column("conf.high", "Wilson high")};
  for (const statistics::CalibrationBin& bin : calibration.bins) {
    table.add_row({number_cell(bin.low),
                   number_cell(bin.high),
                   integer_cell(bin.trials),
                   integer_cell(bin.events),
                   calibration.clusters > 0 ? integer_cell(bin.clusters) : TableCell{},
                   number_cell(bin.predicted),
                   number_cell(bin.observed),
                   low_cell(bin.wilson),
                   high_cell(bin.wilson)});
  }
  return table;
}

Table brier_table(const statistics::ModelCalibration& calibration) {
  Record record("brier", "Brier score and its parts");
  const auto part = [&](double statistics::BrierParts::*member) {
    return calibration.brier ? std::optional((*calibration.brier).*member) : std::nullopt;
  };
  record.number("score", "Brier score", part(&statistics::BrierParts::score))
      .number("reliability", "reliability", part(&statistics::BrierParts::reliability))
      .number("resolution", "resolution", part(&statistics::BrierParts::resolution))
      .number("uncertainty", "uncertainty", part(&statistics::BrierParts::uncertainty))
      .number("within_variance",
              "within bins: variance",
              part(&statistics::BrierParts::within_variance))
      .number("within_covariance", "covariance", part(&statistics::BrierParts::within_covariance));
  Table table = std::move(record).table();
  table.footnotes = {
      "Score = reliability - resolution + uncertainty + variance - covariance, exactly; the last "
      "two "
      "are what the bins' means leave out."};
  return table;
}

Table prediction_table(const CalibrationSource& source) {
  Table table;
  table.name = "predictions";
  table.title = "Predicted probabilities";
  table.columns = {integer_column("row", "row"),
                   number_column("outcome", "outcome"),
                   number_column("predicted", "predicted"),
                   integer_column("fold", "fold")};
  for (std::size_t i = 0; i < source.rows.size(); ++i) {
    table.add_row({integer_cell(source.rows[i] + 1),
                   number_cell(source.outcome[i]),
                   number_cell(source.probability[i]),
                   source.fold.empty() ? TableCell{} : integer_cell(source.fold[i])});
  }
  return table;
}

}  // namespace

FitReport calibration_report(const statistics::ModelCalibration& calibration,
                             const CalibrationSource& source,
                             double level) {
  FitReport report;
  report.model = "calibration";
  const auto& test = calibration.hosmer_lemeshow;
  Record summary("summary", "Calibration");
  summary.integer("nobs", "rows", calibration.rows)
      .integer("events", "events", calibration.events)
      .integer("missing", "without prediction", calibration.missing)
      .integer("clusters", "clusters", calibration.clusters)
      .integer("folds", "folds", source.folds)
      .text("predicted", "predicted", source.folds > 0 ? "out of fold" : source.predicted)
      .number("expected", "expected", calibration.expected)
      .number("expected_to_observed", "E:O", calibration.expected_to_observed)
      .number("brier",
              "Brier score",
              calibration.brier ? std::optional(calibration.brier->score) : std::nullopt)
      .number("statistic",
              "Hosmer-Lemeshow chi-squared",
              test ? std::optional(test->statistic) : std::nullopt)
      .integer("df", "df", test ? test->df : 0)
      .p("p.value", "p", test ? std::optional(test->p_value) : std::nullopt);
  report.summary = std::move(summary).table();
  report.tables = {
      coefficient_table(calibration, level), bin_table(calibration), brier_table(calibration)};
  report.details = {prediction_table(source)};
  report.conditions = calibration.conditions;
  point_to_t(report.conditions);
  return report;
}

}  // namespace tcert
