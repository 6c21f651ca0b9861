#include "analysis/study/h3/cluster_loss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <statistics/basics/binomial_interval.hpp>
#include <vector>

namespace tcert::study {
namespace {

/// Days of `size` trials; of the first days all, of the others none are 1.
struct Days {
  std::vector<std::uint8_t> value;
  std::vector<std::uint32_t> day;
};

Days whole_days(std::uint32_t days, std::uint32_t of_one, std::size_t size) {
  Days made;
  for (std::uint32_t d = 0; d < days; ++d) {
    for (std::size_t i = 0; i < size; ++i) {
      made.value.push_back(d < of_one ? 1 : 0);
      made.day.push_back(d);
    }
  }
  return made;
}

TEST(ClusterLoss, WholeDaysAreTheUnits) {
  const Days lost = whole_days(20, 2, 5);
  EXPECT_NEAR(binary_icc(lost.value, lost.day), 1.0, 1e-12);
  const std::vector<std::uint8_t> none(lost.value.size(), 0);
  const ClusterLoss loss = cluster_loss(lost.value, none, lost.day, 0.95, 0.05);
  EXPECT_NEAR(loss.design_effect, 5.0, 1e-12);
  EXPECT_NEAR(loss.effective_trials(), 20.0, 1e-12);
  EXPECT_NEAR(*loss.upper, *statistics::clopper_pearson_upper(2, 20, 0.95), 1e-12);
}

TEST(ClusterLoss, WithoutClustersItIsClopperAndPearsons) {
  std::vector<std::uint8_t> lost(100, 0);
  std::vector<std::uint8_t> failed(100, 0);
  std::vector<std::uint32_t> own(100);
  for (std::uint32_t i = 0; i < 100; ++i) {
    own[i] = i;
    failed[i] = i % 9 == 0 ? 1 : 0;
  }
  lost[3] = lost[40] = 1;
  const ClusterLoss loss = cluster_loss(lost, failed, own, 0.95, 0.05);
  EXPECT_EQ(loss.design_effect, 1.0);
  EXPECT_NEAR(*loss.upper, *statistics::clopper_pearson_upper(2, 100, 0.95), 1e-12);
  EXPECT_NEAR(*loss.lower, 1.0 - *statistics::clopper_pearson_upper(98, 100, 0.95), 1e-12);
}

TEST(ClusterLoss, FailuresStandInWhereNothingIsLost) {
  const Days failed = whole_days(30, 5, 6);
  const std::vector<std::uint8_t> none(failed.value.size(), 0);
  const ClusterLoss loss = cluster_loss(none, failed.value, failed.day, 0.95, 0.1);
  EXPECT_NEAR(loss.design_effect, 6.0, 1e-12);
  EXPECT_NEAR(*loss.upper, 1.0 - std::pow(0.05, 1.0 / 30.0), 1e-12)
      << "thirty days, not 180 trials";
  EXPECT_EQ(*loss.lower, 0.0);
}

TEST(ClusterLoss, TheTestIsTheBoundInverted) {
  const Days failed = whole_days(40, 4, 4);
  for (std::size_t lost_trials = 0; lost_trials < 20; ++lost_trials) {
    std::vector<std::uint8_t> lost(failed.value.size(), 0);
    for (std::size_t i = 0; i < lost_trials; ++i) {
      lost[(i * 37) % lost.size()] = 1;
    }
    const ClusterLoss loss = cluster_loss(lost, failed.value, failed.day, 0.95, 0.08);
    EXPECT_EQ(*loss.p < 0.05, *loss.upper < 0.08) << lost_trials;
  }
}

/// Exact power by adding the binomial probabilities of what is found below the margin.
double power_of(std::size_t trials, double lost, double margin) {
  double sum = 0.0;
  double probability = std::pow(1.0 - lost, static_cast<double>(trials));
  for (std::size_t k = 0; k <= trials; ++k) {
    if (*statistics::clopper_pearson_upper(k, trials, 0.95) >= margin) {
      break;
    }
    sum += probability;
    probability *=
        lost / (1.0 - lost) * static_cast<double>(trials - k) / (static_cast<double>(k) + 1.0);
  }
  return sum;
}

TEST(ClusterLoss, TrialsForPowerAreTheLeastThatKeepIt) {
  EXPECT_EQ(trials_for_power(0.0, 0.05, 0.95, 0.8), 59.0) << "log 0.05 / log 0.95";
  for (const double lost : {0.005, 0.01, 0.02}) {
    const auto found = static_cast<std::size_t>(*trials_for_power(lost, 0.05, 0.95, 0.8));
    EXPECT_GE(power_of(found, lost, 0.05), 0.8);
    EXPECT_LT(power_of(found - 1, lost, 0.05), 0.8);
    std::size_t below = 0;
    for (std::size_t n = found; n < 2 * found; ++n) {
      below += power_of(n, lost, 0.05) < 0.8 ? 1 : 0;
    }
    EXPECT_EQ(below, 0U) << lost;
  }
  EXPECT_FALSE(trials_for_power(0.05, 0.05, 0.95, 0.8));
}

}  // namespace
}  // namespace tcert::study
