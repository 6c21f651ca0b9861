#pragma once
/// \file
/// Predictions of fits for other rows, and scores of predicted risks.

#include <cstddef>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/cox/cox_baseline.hpp>
#include <statistics/survival/time_scores.hpp>
#include <string>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

struct ProbabilityRow {
  std::size_t row = 0;  ///< Of its table, from 1.
  std::optional<double> probability;
  std::optional<statistics::Interval> interval;
  std::optional<double> log_odds;
  std::optional<double> std_error;  ///< Of the log odds.
};

/// By what the intervals of predictions are where there are clusters.
[[nodiscard]] std::string prediction_footnote(std::size_t clusters,
                                              statistics::ClusterInference by);

[[nodiscard]] Table probability_table(const std::vector<ProbabilityRow>& rows);

struct SurvivalRow {
  std::size_t row = 0;
  std::string stratum;
  double time = 0.0;
  double survival = 1.0;
  std::optional<double> std_error;
  std::optional<statistics::Interval> interval;  ///< Of the survival.
};

/// The curve at the last of its times that is not later; 1 before the first.
[[nodiscard]] SurvivalRow survival_at(const statistics::CoxCurve& curve,
                                      std::size_t row,
                                      double time);

[[nodiscard]] Table survival_prediction_table(const std::vector<SurvivalRow>& rows);

[[nodiscard]] Table time_score_table(const std::vector<statistics::TimeScores>& scores);

/// Risks by one time, out of fold.
struct TimeCalibration {
  statistics::TimeScores scores;
  statistics::RiskBin whole;  ///< All rows.
  std::vector<statistics::RiskBin> bins;
  std::optional<double> slope;
  std::optional<statistics::Interval> slope_interval;
};

/// Tables scores, calibration, bins. `missing` rows have no risk.
[[nodiscard]] FitReport time_calibration_report(const std::vector<TimeCalibration>& times,
                                                std::size_t missing,
                                                std::size_t folds);

}  // namespace tcert
