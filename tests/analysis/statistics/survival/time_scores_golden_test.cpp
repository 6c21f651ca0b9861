// What R says of predicted risks (scripts/golden/predictions.R).

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/cox/cox_predict.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/survival/restricted_means.hpp>
#include <statistics/survival/time_scores.hpp>
#include <table/not_a_number.hpp>

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

SurvivalOutcome outcome_of(std::vector<double> stop, std::vector<std::uint8_t> event) {
  SurvivalOutcome outcome;
  outcome.stop = std::move(stop);
  outcome.event = std::move(event);
  return outcome;
}

/// Of years and of years since 2000 the risks are the same: a hazard at x = 0 would underflow.
TEST(CoxRisks, DoNotDependOnWhereAColumnBegins) {
  CoxData data;
  data.outcome = outcome_of({1, 2, 3, 4, 5, 6, 7, 8}, {1, 1, 1, 0, 1, 1, 1, 0});
  data.columns = data.terms = {"year"};
  data.term_of = {0};
  data.design.resize(8, 1);
  data.design.col(0) << 1, 2, 0, 3, 2, 4, 3, 5;
  CoxData shifted = data;
  shifted.design.array() += 2000.0;
  const std::vector<double> times{0.5, 3.0, 8.0};
  const Eigen::MatrixXd near = cox_risks(data, fit_cox(data), data, times);
  const Eigen::MatrixXd far = cox_risks(shifted, fit_cox(shifted), shifted, times);
  ASSERT_TRUE(far.allFinite());
  EXPECT_LT((near - far).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_EQ(far.col(0).cwiseAbs().maxCoeff(), 0.0);
}

TEST(TimeScores, ARiskThatIsNoNumberIsLeftOut) {
  const SurvivalOutcome outcome = outcome_of({1, 2, 3, 4, 5}, {1, 1, 1, 1, 1});
  const std::vector<double> risk{0.9, table::kNaN, 0.5, 0.2, 0.1};
  const TimeScores all = time_scores(outcome, risk, 3.0, nullptr, 0.95);
  const std::vector<double> known{0.9, 0.5, 0.2, 0.1};
  const TimeScores without =
      time_scores(outcome_of({1, 3, 4, 5}, {1, 1, 1, 1}), known, 3.0, nullptr, 0.95);
  EXPECT_DOUBLE_EQ(all.auc.value, without.auc.value);
  EXPECT_DOUBLE_EQ(all.brier.value, without.brier.value);
  EXPECT_EQ(all.cases, 2U);
  EXPECT_EQ(risk_bins(outcome, risk, 3.0, 1, nullptr, 0.95).front().rows, 4U);
}

TEST(TimeScores, BeyondAllThatIsKnownThereIsNone) {
  const SurvivalOutcome outcome = outcome_of({1, 2, 3, 4, 5}, {1, 0, 1, 1, 0});
  const std::vector<double> risk{0.9, 0.7, 0.5, 0.2, 0.1};
  EXPECT_TRUE(std::isfinite(time_scores(outcome, risk, 4.0, nullptr, 0.95).brier.value));
  for (const double time : {5.0, 50.0}) {
    const TimeScores scores = time_scores(outcome, risk, time, nullptr, 0.95);
    EXPECT_TRUE(std::isnan(scores.auc.value));
    EXPECT_TRUE(std::isnan(scores.brier.value));
    EXPECT_TRUE(std::isnan(scores.brier_null));
  }
}

TEST(TimeScores, IntervalsLieWithinWhatAScoreCanBe) {
  const SurvivalOutcome outcome = outcome_of({1, 2, 3, 4, 5, 6}, {1, 1, 1, 1, 1, 1});
  const std::vector<double> risk{0.9, 0.4, 0.5, 0.45, 0.2, 0.1};
  table::Factor cluster;
  cluster.levels = {"a", "b", "c"};
  cluster.codes = {0, 1, 2, 0, 1, 2};
  const TimeScores scores = time_scores(outcome, risk, 3.0, &cluster, 0.95);
  ASSERT_TRUE(scores.auc.spread.interval && scores.brier.spread.interval);
  for (const Interval& one : {*scores.auc.spread.interval, *scores.brier.spread.interval}) {
    EXPECT_GE(one.low, 0.0);
    EXPECT_LE(one.high, 1.0);
  }
}

/// Half of the rows tie at the least risk: the bins they fill are not followed by bins of one row.
TEST(RiskBins, ALargeTieIsOneBinAndLeavesTheOthersTheirSize) {
  std::vector<double> risk(50, 0.1);
  for (int k = 0; k < 50; ++k) {
    risk.push_back(0.2 + 0.01 * k);
  }
  std::vector<double> stop;
  for (int k = 0; k < 100; ++k) {
    stop.push_back(1.0 + k);
  }
  const auto bins =
      risk_bins(outcome_of(stop, std::vector<std::uint8_t>(100, 1)), risk, 60.0, 10, nullptr, 0.95);
  ASSERT_EQ(bins.size(), 6U);
  EXPECT_EQ(bins.front().rows, 50U);
  for (std::size_t b = 1; b < 6; ++b) {
    EXPECT_EQ(bins[b].rows, 10U);
  }
}

TEST(RestrictedMeans, BeyondACurveThatEndsAboveZeroThereIsNone) {
  const SurvivalOutcome outcome = outcome_of({1, 2, 3, 2, 4, 9}, {1, 1, 1, 1, 0, 0});
  table::Factor group;
  group.levels = {"all end", "one is left"};
  group.codes = {0, 0, 0, 1, 1, 1};
  const auto within = restricted_means(outcome, &group, nullptr, 9.0, 0.95);
  EXPECT_DOUBLE_EQ(within[0].value, 2.0);
  EXPECT_TRUE(std::isfinite(within[1].value));
  const auto beyond = restricted_means(outcome, &group, nullptr, 10.0, 0.95);
  EXPECT_DOUBLE_EQ(beyond[0].value, 2.0) << "a curve at 0 is known for ever";
  EXPECT_TRUE(std::isnan(beyond[1].value));
  EXPECT_TRUE(std::isnan(beyond[2].value));
  EXPECT_FALSE(beyond[1].spread.interval);
}

/// The second group lies on three of six days: it has two degrees of freedom, and so has the
/// difference.
TEST(RestrictedMeans, DegreesOfFreedomAreThoseOfTheGroupOnTheFewestClusters) {
  std::vector<double> stop;
  table::Factor group;
  group.levels = {"everywhere", "on three days"};
  table::Factor day;
  day.levels = {"1", "2", "3", "4", "5", "6"};
  for (std::uint32_t k = 0; k < 24; ++k) {
    stop.push_back(1.0 + (k * 7) % 13);
    day.codes.push_back(k % 6);
    group.codes.push_back(k % 6 < 3 && k >= 12 ? 1 : 0);
  }
  const auto rows =
      restricted_means(outcome_of(stop, std::vector<std::uint8_t>(24, 1)), &group, &day, 5.0, 0.95);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].spread.df, 5.0);
  EXPECT_EQ(rows[1].spread.df, 2.0);
  EXPECT_EQ(rows[2].spread.df, 2.0);
}

TEST(TimeScores, VeryManyClustersAreNotLeftOutInTurn) {
  EXPECT_FALSE(too_much_to_leave_out(660, 660));
  ASSERT_TRUE(too_much_to_leave_out(20'000, 20'000));
  std::vector<double> stop;
  std::vector<double> risk;
  table::Factor own;
  for (std::uint32_t k = 0; k < 20'000; ++k) {
    stop.push_back(1.0 + k);
    risk.push_back((k * 7919) % 20'000 / 20'000.0);
    own.codes.push_back(k);
    own.levels.push_back(std::to_string(k));
  }
  const TimeScores scores = time_scores(
      outcome_of(stop, std::vector<std::uint8_t>(20'000, 1)), risk, 9'000.0, &own, 0.95);
  EXPECT_TRUE(std::isfinite(scores.auc.value));
  EXPECT_FALSE(scores.auc.spread.interval);
}

}  // namespace
}  // namespace tcert::statistics
