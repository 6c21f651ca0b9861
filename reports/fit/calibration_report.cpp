#include "reports/fit/calibration_report.hpp"

#include "reports/fit/cells.hpp"
#include "reports/fit/interval_columns.hpp"

namespace tcert {
namespace {

struct Part : RowOf<statistics::WaldEstimate> {
  std::string name;
  double ideal;
};

Table coefficient_table(const statistics::ModelCalibration& calibration, double level) {
  using Coefficient = statistics::WaldEstimate;
  const bool clustered = calibration.clusters > 0;
  ColumnsOf<Part> columns;
  columns.text("term", "quantity", &Part::name)
      .number("estimate", "estimate", &Coefficient::estimate)
      .number("std.error", "SE", &Coefficient::standard_error)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &Coefficient::interval);
  if (clustered) {
    columns.part(t_columns(false), [&](auto& r) {
      return std::optional(statistics::by_cluster_t(
          r.of.estimate, r.of.standard_error, {}, calibration.clusters, level));
    });
  }
  columns.number("ideal", "ideal", &Part::ideal);
  Table table =
      columns.table("calibration",
                    "Calibration of predicted probabilities",
                    std::vector<Part>{{{calibration.slope}, "slope", 1.0},
                                      {{calibration.intercept}, "intercept", 0.0},
                                      {{calibration.in_the_large}, "intercept, slope 1", 0.0}});
  table.n = static_cast<std::int64_t>(calibration.rows);
  table.footnotes = {
      "Slope and intercept: outcome on logit p, logistic. Below 1 the probabilities are too "
      "extreme; "
      "an intercept above 0 with slope 1 says that they are too low on average.",
      clustered
          ? "Errors are cluster-robust; intervals of the bins and the Hosmer-Lemeshow test take "
            "trials as independent, so with clusters they are too sure of themselves."
          : "Trials are taken as independent."};
  if (clustered) {
    table.footnotes.push_back(t_footnote(calibration.clusters));
  }
  return table;
}

Table bin_table(const statistics::ModelCalibration& calibration) {
  using Bin = statistics::CalibrationBin;
  Table table =
      ColumnsOf<Bin>()
          .number("p.low", "above", &Bin::low)
          .number("p.high", "to", &Bin::high)
          .integer("n", "n", &Bin::trials)
          .integer("events", "events", &Bin::events)
          .integer("clusters",
                   "clusters",
                   [&](auto& bin) { return when(calibration.clusters > 0, bin.clusters); })
          .number("predicted", "predicted", &Bin::predicted)
          .number("observed", "observed", &Bin::observed)
          .ends({"conf.low", "Wilson low"}, {"conf.high", "Wilson high"}, &Bin::wilson)
          .table("bins", "Observed by predicted: bins of equal size", calibration.bins);
  table.n = static_cast<std::int64_t>(calibration.rows);
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
  const auto columns =
      ColumnsOf<std::size_t>()
          .integer("row", "row", [&](std::size_t i) { return source.rows[i] + 1; })
          .number("outcome", "outcome", [&](std::size_t i) { return source.outcome[i]; })
          .number("predicted", "predicted", [&](std::size_t i) { return source.probability[i]; })
          .integer("fold", "fold", [&](std::size_t i) {
            return source.fold.empty() ? std::nullopt : std::optional(source.fold[i]);
          });
  Table table = columns.table("predictions", "Predicted probabilities");
  for (std::size_t i = 0; i < source.rows.size(); ++i) {
    table.add_row(columns.row(i));
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
      .number("statistic", "Hosmer-Lemeshow chi-squared", statistic_of(test))
      .integer("df", "df", test ? test->df : 0)
      .p("p.value", "p", p_of(test));
  report.summary = std::move(summary).table();
  report.tables = {
      coefficient_table(calibration, level), bin_table(calibration), brier_table(calibration)};
  report.details = {prediction_table(source)};
  report.conditions = calibration.conditions;
  point_to_t(report.conditions);
  return report;
}

}  // namespace tcert
