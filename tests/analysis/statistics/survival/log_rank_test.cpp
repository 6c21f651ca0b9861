#include <statistics/survival/log_rank.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

TEST(LogRank, AddsUpByHand) {
  // Group a: 1, 3; group b: 2, 4+. Expected of a: 2/4 + 1/3 + 1/2 = 4/3; observed 2. Variance:
  // 1/4 + 2/9 + 1/4 = 13/18. Chi squared (2/3)^2 / (13/18) = 8/13.
  const SurvivalOutcome outcome{{}, {1, 3, 2, 4}, {1, 1, 1, 0}};
  const LogRankTest test = log_rank_test(outcome, {{0, 0, 1, 1}, {"a", "b"}});
  EXPECT_EQ(test.groups[0].observed, 2.0);
  EXPECT_NEAR(test.groups[0].expected, 4.0 / 3.0, 1e-15);
  EXPECT_NEAR(test.groups[1].expected, 5.0 / 3.0, 1e-15);
  EXPECT_NEAR(test.covariance(0, 0), 13.0 / 18.0, 1e-15);
  EXPECT_NEAR(test.chi_squared.value(), 8.0 / 13.0, 1e-14);
  EXPECT_EQ(test.df, 1U);
}

TEST(LogRank, NamesWhatItCannotTest) {
  const SurvivalOutcome outcome{{}, {1, 2}, {1, 1}};
  EXPECT_TRUE(has(log_rank_test(outcome, {{0, 0}, {"a"}}).conditions, ConditionKind::one_group));
  const LogRankTest censored = log_rank_test({{}, {1, 2}, {0, 0}}, {{0, 1}, {"a", "b"}});
  EXPECT_TRUE(has(censored.conditions, ConditionKind::no_events));
  EXPECT_FALSE(censored.p_value.has_value());
  EXPECT_THROW(static_cast<void>(log_rank_test(outcome, {{0, 2}, {"a", "b"}})),
               std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(log_rank_test(
          outcome, {{0, 1}, {"a", "b"}}, nullptr, std::numeric_limits<double>::infinity())),
      std::invalid_argument);
}

TEST(LogRank, AGroupAddsOnlyWhileItIsAtRisk) {
  // Of many groups few are at risk together; each pair against the sum of its definition.
  table::RandomStream random(43, 1, 0);
  SurvivalOutcome outcome;
  table::Factor groups;
  constexpr std::uint32_t kGroups = 40;
  for (std::uint32_t row = 0; row < 4 * kGroups; ++row) {
    const std::uint32_t group = row % kGroups;
    outcome.start.push_back(group / 4);
    outcome.stop.push_back(group / 4 + 1.0 + random.below(3));
    outcome.event.push_back(random.below(3) == 0 ? 0 : 1);
    groups.codes.push_back(group);
  }
  for (std::uint32_t group = 0; group < kGroups; ++group) {
    groups.levels.push_back("g" + std::to_string(100 + group));
  }
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(kGroups, kGroups);
  for (int time = 1; time < 20; ++time) {
    Eigen::VectorXd at_risk = Eigen::VectorXd::Zero(kGroups);
    double events = 0.0;
    for (std::size_t row = 0; row < outcome.stop.size(); ++row) {
      at_risk(groups.codes[row]) += outcome.start[row] < time && outcome.stop[row] >= time ? 1 : 0;
      events += outcome.stop[row] == time && outcome.event[row] == 1 ? 1.0 : 0.0;
    }
    const double all = at_risk.sum();
    if (events > 0.0 && all > 1.0) {
      const double scale = events * (all - events) / (all * (all - 1.0));
      expected +=
          scale * (Eigen::MatrixXd(at_risk.asDiagonal()) - at_risk * at_risk.transpose() / all);
    }
  }
  EXPECT_LT((log_rank_test(outcome, groups).covariance - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LogRank, TakesACommonStartForNone) {
  table::RandomStream random(41, 1, 0);
  SurvivalOutcome outcome;
  table::Factor groups{{}, {"a", "b", "c"}};
  for (int row = 0; row < 90; ++row) {
    outcome.stop.push_back(16.0 + random.below(20));
    outcome.event.push_back(random.below(4) == 0 ? 0 : 1);
    groups.codes.push_back(random.below(3));
  }
  const LogRankTest plain = log_rank_test(outcome, groups, nullptr, 1.0);
  outcome.start.assign(90, 15.0);
  EXPECT_EQ(log_rank_test(outcome, groups, nullptr, 1.0).chi_squared, plain.chi_squared);
}

}  // namespace
}  // namespace tcert::statistics
