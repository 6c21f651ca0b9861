// What R says of predicted risks (scripts/golden/predictions.R).

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/cox/cox_predict.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/survival/time_scores.hpp>

#include "analysis/statistics/golden_table.hpp"

namespace tcert::statistics {
namespace {

using nlohmann::json;

json golden() { return golden_json("predictions.json"); }

CoxData data_of(const json& all) {
  CoxData data;
  data.outcome.stop = golden_numbers(all, "time");
  const std::vector<double> events = golden_numbers(all, "event");
  for (const double event : events) {
    data.outcome.event.push_back(event == 1.0 ? 1 : 0);
  }
  data.columns = {"x", "z", "lightdim"};
  data.terms = {"x", "z", "light"};
  data.term_of = {0, 1, 2};
  const auto rows = static_cast<Eigen::Index>(data.outcome.stop.size());
  data.design.resize(rows, 3);
  const std::vector<double> x = golden_numbers(all, "x");
  const std::vector<double> z = golden_numbers(all, "z");
  const std::vector<std::string> light = golden_texts(all).at("light");
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto at = static_cast<std::size_t>(row);
    data.design.row(row) << x[at], z[at], light[at] == "dim" ? 1.0 : 0.0;
  }
  return data;
}

TEST(TimeScoresGolden, RisksAreThoseOfSurvfit) {
  const json all = golden();
  const CoxData data = data_of(all);
  const auto times = all["times"].get<std::vector<double>>();
  const Eigen::MatrixXd risks = cox_risks(data, fit_cox(data), data, times);
  for (Eigen::Index row = 0; row < risks.rows(); ++row) {
    for (Eigen::Index t = 0; t < risks.cols(); ++t) {
      EXPECT_NEAR(
          risks(row, t),
          all["risk"][static_cast<std::size_t>(row)][static_cast<std::size_t>(t)].get<double>(),
          1e-9);
    }
  }
}

TEST(TimeScoresGolden, ScoresAreThoseOfRiskRegression) {
  const json all = golden();
  const CoxData data = data_of(all);
  const auto times = all["times"].get<std::vector<double>>();
  const Eigen::MatrixXd risks = cox_risks(data, fit_cox(data), data, times);
  const table::Factor day = levels_by_value(golden_numbers(all, "day"));
  for (std::size_t t = 0; t < times.size(); ++t) {
    const Eigen::VectorXd column = risks.col(static_cast<Eigen::Index>(t));
    const std::vector<double> risk(column.data(), column.data() + column.size());
    const TimeScores scores = time_scores(data.outcome, risk, times[t], &day, 0.95);
    EXPECT_NEAR(scores.auc.value, all["auc"][t].get<double>(), 1e-9);
    EXPECT_NEAR(scores.brier.value, all["brier"][t].get<double>(), 1e-9);
    EXPECT_NEAR(scores.brier_null, all["brier_null"][t].get<double>(), 1e-9);
    EXPECT_EQ(*scores.auc.spread.df, 14.0);
    EXPECT_LT(scores.auc.spread.interval->low, scores.auc.value);
    const auto bins = risk_bins(data.outcome, risk, times[t], 5, nullptr, 0.95);
    ASSERT_EQ(bins.size(), 5U);
    for (std::size_t b = 0; b < 5; ++b) {
      EXPECT_NEAR(bins[b].predicted, all["bins"][t]["predicted"][b].get<double>(), 1e-9);
      EXPECT_NEAR(bins[b].observed, all["bins"][t]["observed"][b].get<double>(), 1e-9);
    }
  }
}

/// Without censoring the weights are 1, and the AUC is that of the outcome by the time.
TEST(TimeScores, WithoutCensoringTheyAreThoseOfTheOutcome) {
  const SurvivalOutcome outcome{{}, {1.0, 2.0, 3.0, 4.0}, {1, 1, 1, 1}};
  const std::vector<double> risk{0.9, 0.2, 0.4, 0.2};
  const TimeScores scores = time_scores(outcome, risk, 2.0, nullptr, 0.95);
  EXPECT_DOUBLE_EQ(scores.auc.value, (1.0 + 1.0 + 0.0 + 0.5) / 4.0);
  EXPECT_DOUBLE_EQ(scores.brier.value, (0.01 + 0.64 + 0.16 + 0.04) / 4.0);
  EXPECT_DOUBLE_EQ(scores.brier_null, 0.25);
  EXPECT_FALSE(scores.auc.spread.interval);
}

}  // namespace
}  // namespace tcert::statistics
