#include <statistics/model/pairwise.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <statistics/basics/normal.hpp>
#include <statistics/basics/student_t.hpp>

namespace tcert::statistics {
namespace {

/// Three levels by treatment contrasts beside an intercept.
LevelMeans three_levels() {
  LevelMeans means;
  means.levels = {"a", "b", "c"};
  means.design.resize(3, 3);
  means.design << 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0;
  return means;
}

TEST(Pairwise, DifferencesErrorsAndHolmByHand) {
  const std::vector<std::optional<double>> beta{5.0, 1.0, -0.5};
  const Eigen::Matrix3d covariance{{9.0, 1.0, 1.0}, {1.0, 0.25, 0.05}, {1.0, 0.05, 0.36}};
  const auto pairs = pairwise_contrasts(
      three_levels(),
      [&](const Eigen::MatrixXd& weights) {
        return sums_by_covariance(beta, covariance, 7.0, weights);
      },
      0.95);
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[2].first, "b");
  EXPECT_EQ(pairs[2].second, "c");
  EXPECT_NEAR(*pairs[0].estimate, -1.0, 1e-15);
  EXPECT_NEAR(*pairs[0].standard_error, 0.5, 1e-15) << "the intercept cancels";
  EXPECT_NEAR(*pairs[2].estimate, 1.5, 1e-15);
  EXPECT_NEAR(*pairs[2].standard_error, std::sqrt(0.25 + 0.36 - 0.1), 1e-15);
  const double half = t_factor(0.95, 7.0) * 0.5;
  EXPECT_NEAR(pairs[0].interval->low, -1.0 - half, 1e-12);
  EXPECT_NEAR(pairs[0].simultaneous->high, -1.0 + t_factor(1.0 - 0.05 / 3.0, 7.0) * 0.5, 1e-12);
  // By size: pair 2 (t 2.1), pair 0 (t 2), pair 1 (t 0.83).
  EXPECT_NEAR(*pairs[2].holm, 3.0 * *pairs[2].p_value, 1e-12);
  EXPECT_NEAR(*pairs[0].holm, std::max(3.0 * *pairs[2].p_value, 2.0 * *pairs[0].p_value), 1e-12);
  EXPECT_NEAR(*pairs[1].holm, *pairs[1].p_value, 1e-12);
}

TEST(Pairwise, WhatCannotBeEstimatedIsMissingAndNotCounted) {
  const std::vector<std::optional<double>> beta{5.0, 1.0, std::nullopt};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  covariance.row(2).setConstant(std::numeric_limits<double>::quiet_NaN());
  covariance.col(2).setConstant(std::numeric_limits<double>::quiet_NaN());
  const auto pairs = pairwise_contrasts(
      three_levels(),
      [&](const Eigen::MatrixXd& weights) {
        return sums_by_covariance(beta, covariance, {}, weights);
      },
      0.95);
  EXPECT_NEAR(*pairs[0].p_value, normal_p_value(1.0, Alternative::two_sided), 1e-15);
  EXPECT_EQ(pairs[0].holm, pairs[0].p_value) << "a family of one";
  for (const std::size_t k : {1U, 2U}) {
    EXPECT_FALSE(pairs[k].estimate);
    EXPECT_FALSE(pairs[k].holm);
    EXPECT_FALSE(pairs[k].simultaneous);
  }
}

}  // namespace
}  // namespace tcert::statistics
