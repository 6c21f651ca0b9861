#include <statistics/basics/wald_chi_squared.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace tcert::statistics {
namespace {

TEST(WaldTest, ByHandAndInAnyUnits) {
  const Eigen::Vector2d estimates(1.0, 2.0);
  Eigen::Matrix2d covariance;
  covariance << 2.0, 1.0, 1.0, 1.0;
  // The inverse is [1 -1; -1 2]: 1 - 4 + 8.
  const ChiSquareTest test = wald_test(estimates, covariance).value();
  EXPECT_NEAR(test.statistic, 5.0, 1e-14);
  EXPECT_EQ(test.df, 2U);
  const Eigen::Matrix2d units = Eigen::Vector2d(1e9, 1e-9).asDiagonal();
  EXPECT_NEAR(wald_test(units * estimates, units * covariance * units)->statistic, 5.0, 1e-12);
}

TEST(WaldTest, IsEmptyWithoutAnInverse) {
  const Eigen::Vector2d estimates(1.0, 2.0);
  EXPECT_FALSE(wald_test(estimates, Eigen::Matrix2d::Ones()).has_value());
  EXPECT_FALSE(wald_test(estimates, Eigen::Matrix2d::Zero()).has_value());
  EXPECT_FALSE(wald_test(Eigen::VectorXd(0), Eigen::MatrixXd(0, 0)).has_value());
  Eigen::Matrix2d missing = Eigen::Matrix2d::Identity();
  missing(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(wald_test(estimates, missing).has_value());
}

}  // namespace
}  // namespace tcert::statistics
