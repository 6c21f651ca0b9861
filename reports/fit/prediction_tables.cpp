#include "reports/fit/prediction_tables.hpp"

#include <algorithm>
#include <cmath>

#include "reports/columns_of.hpp"

namespace tcert {

std::string prediction_footnote(std::size_t clusters, statistics::ClusterInference by) {
  if (clusters < 2) {
    return "There is a single cluster: no standard errors and intervals by clusters.";
  }
  std::string words = by == statistics::ClusterInference::jackknife ? "jackknife of whole clusters"
                      : by == statistics::ClusterInference::cr2     ? "CR2"
                                                                    : "CR1";
  words = "Intervals: coefficients' covariance by " + words +
          ", Student's t with clusters - 1 = " + std::to_string(clusters - 1) +
          " degrees of freedom";
  if (by == statistics::ClusterInference::cr2) {
    return words + "; Satterthwaite's are of a coefficient, a row has none.";
  }
  return words + (by == statistics::ClusterInference::wild
                      ? "; the wild bootstrap is of a coefficient, a row has none."
                      : ".");
}

Table probability_table(const std::vector<ProbabilityRow>& rows) {
  using Row = ProbabilityRow;
  return ColumnsOf<Row>()
      .integer("row", "row", &Row::row)
      .number("estimate", "probability", &Row::probability)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &Row::interval)
      .number("log.odds", "log odds", &Row::log_odds)
      .number("std.error", "SE", &Row::std_error)
      .table("predictions", "Predicted probabilities", rows);
}

SurvivalRow survival_at(const statistics::CoxCurve& curve, std::size_t row, double time) {
  SurvivalRow result{row, curve.stratum, time, 1.0, {}, {}};
  const auto next = std::upper_bound(curve.time.begin(), curve.time.end(), time);
  if (next != curve.time.begin()) {
    const auto at = static_cast<std::size_t>(next - curve.time.begin()) - 1;
    result.survival = curve.survival[at];
    if (!std::isnan(curve.std_err[at])) {
      result.std_error = curve.std_err[at];
    }
    if (!std::isnan(curve.lower[at]) && !std::isnan(curve.upper[at])) {
      result.interval = statistics::Interval{curve.lower[at], curve.upper[at]};
    }
  }
  return result;
}

Table survival_prediction_table(const std::vector<SurvivalRow>& rows) {
  using Row = SurvivalRow;
  return ColumnsOf<Row>()
      .integer("row", "row", &Row::row)
      .text("strata", "stratum", &Row::stratum)
      .time("time", "time", &Row::time)
      .number("estimate", "survival", &Row::survival)
      .number("std.error", "SE", &Row::std_error)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &Row::interval)
      .number("risk", "risk", [](const Row& r) { return 1.0 - r.survival; })
      .table("predictions", "Predicted survival and risk", rows);
}

Table time_score_table(const std::vector<statistics::TimeScores>& scores) {
  using Scores = statistics::TimeScores;
  Table table =
      ColumnsOf<Scores>()
          .time("time", "time", &Scores::time)
          .integer("cases", "events by then", &Scores::cases)
          .integer("controls", "later", &Scores::controls)
          .number("auc", "AUC(t)", [](auto& r) { return r.auc.value; })
          .ends({"auc.low", "low"},
                {"auc.high", "high"},
                [](auto& r) { return r.auc.spread.interval; })
          .number("brier", "Brier(t)", [](auto& r) { return r.brier.value; })
          .ends({"brier.low", "low"},
                {"brier.high", "high"},
                [](auto& r) { return r.brier.spread.interval; })
          .number("brier.null", "without the model", &Scores::brier_null)
          .number("ipa", "gain", [](auto& r) { return 1.0 - r.brier.value / r.brier_null; })
          .table("scores", "Predicted risks at times, weighted for censoring", scores);
  table.footnotes = {
      "Gain: 1 - Brier(t) / that of the same risk for all. Intervals: jackknife of whole clusters "
      "and "
      "t, risks held; none without clusters."};
  return table;
}

FitReport time_calibration_report(const std::vector<TimeCalibration>& times,
                                  std::size_t missing,
                                  std::size_t folds) {
  using Calibration = TimeCalibration;
  struct BinRow {
    double time = 0.0;
    statistics::RiskBin bin;
  };
  FitReport report;
  report.model = "calibration";
  std::vector<statistics::TimeScores> scores;
  std::vector<BinRow> bins;
  std::size_t rows = 0;
  for (const Calibration& one : times) {
    scores.push_back(one.scores);
    rows = one.whole.rows;
    for (const statistics::RiskBin& bin : one.bins) {
      bins.push_back({one.scores.time, bin});
    }
  }
  Record summary("summary", "Calibration at times");
  summary.integer("nobs", "rows", rows)
      .integer("missing", "without prediction", missing)
      .integer("folds", "folds", folds)
      .text("predicted", "predicted", "out of fold");
  report.summary = std::move(summary).table();
  Table calibration =
      ColumnsOf<Calibration>()
          .time("time", "time", [](auto& r) { return r.scores.time; })
          .number("expected", "mean risk", [](auto& r) { return r.whole.predicted; })
          .number("estimate", "observed", [](auto& r) { return r.whole.observed; })
          .ends(
              {"conf.low", "low"}, {"conf.high", "high"}, [](auto& r) { return r.whole.interval; })
          .number("slope", "slope", &Calibration::slope)
          .ends({"slope.low", "low"}, {"slope.high", "high"}, &Calibration::slope_interval)
          .table("calibration", "Predicted and observed risks at times, out of fold", times);
  calibration.footnotes = {
      "Observed: 1 - Kaplan-Meier, clustered where clusters are named. Slope: of log(-log(1 - "
      "risk)) "
      "in a Cox model of the time up to then; below 1 the risks lie too far apart. Knots and means "
      "of ns(), poly() and scale() are those of all rows."};
  report.tables = {std::move(calibration), time_score_table(scores)};
  report.tables.push_back(
      ColumnsOf<BinRow>()
          .time("time", "time", &BinRow::time)
          .integer("rows", "rows", [](auto& r) { return r.bin.rows; })
          .number("predicted", "mean risk", [](auto& r) { return r.bin.predicted; })
          .number("observed", "observed", [](auto& r) { return r.bin.observed; })
          .ends({"conf.low", "low"}, {"conf.high", "high"}, [](auto& r) { return r.bin.interval; })
          .table("bins", "Observed by predicted: bins of about equal size", bins));
  return report;
}

}  // namespace tcert
