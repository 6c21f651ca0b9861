#include <statistics/survival/failures_at_limit.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {
namespace {

TEST(FailuresAtLimit, KeepsFailuresAtRiskAndLeavesTheRestAlone) {
  // Egress at 10, failure at 12, censored otherwise at 20, failure after the limit.
  const SurvivalOutcome outcome{{1, 1, 1, 1}, {10, 12, 20, 61}, {1, 0, 0, 0}};
  const std::vector<std::uint8_t> failure{0, 1, 0, 1};
  const SurvivalOutcome result = failures_at_limit(outcome, failure, 60.0);
  EXPECT_EQ(result.start, outcome.start);
  EXPECT_EQ(result.stop, (std::vector<double>{10, 60, 20, 61}));
  EXPECT_EQ(result.event, outcome.event);
}

TEST(FailuresAtLimit, RefusesMisuse) {
  const SurvivalOutcome outcome{{}, {10, 12}, {1, 0}};
  const auto run = [&](const std::vector<std::uint8_t>& failure, double limit) {
    static_cast<void>(failures_at_limit(outcome, failure, limit));
  };
  EXPECT_THROW(run({0}, 60.0), std::invalid_argument);
  EXPECT_THROW(run({1, 0}, 60.0), std::invalid_argument) << "an egress is no failure";
  EXPECT_THROW(run({0, 2}, 60.0), std::invalid_argument);
  EXPECT_THROW(run({0, 1}, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
