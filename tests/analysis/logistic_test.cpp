#include "analysis/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace tcert {
namespace {

/// y ~ 1 + x.
LogisticInput on(std::initializer_list<double> x, std::initializer_list<double> y) {
  LogisticInput input;
  input.design.resize(static_cast<Eigen::Index>(x.size()), 2);
  input.design.col(0).setOnes();
  std::copy(x.begin(), x.end(), input.design.col(1).begin());
  input.columns = {"(Intercept)", "x"};
  input.term_of = {0, 1};
  input.terms = {"x"};
  input.successes.resize(static_cast<Eigen::Index>(y.size()));
  std::copy(y.begin(), y.end(), input.successes.begin());
  return input;
}

TEST(Logistic, EqualsTheTwoByTwoTableByHand) {
  // Group 0: 1 success of 4; group 1: 3 of 4. Odds 1/3 and 3: intercept -log 3, slope 2 log 3,
  // variance of the intercept 1/1 + 1/3, of the slope twice that.
  const LogisticFit fit = fit_logistic(on({0, 0, 0, 0, 1, 1, 1, 1}, {1, 0, 0, 0, 1, 1, 1, 0}));
  EXPECT_TRUE(fit.conditions.empty());
  EXPECT_EQ(fit.termination, Termination::converged);
  EXPECT_NEAR(fit.coefficients[0].estimate.value(), -std::log(3.0), 1e-15);
  EXPECT_NEAR(fit.coefficients[1].estimate.value(), 2.0 * std::log(3.0), 1e-14);
  EXPECT_NEAR(fit.covariance(0, 0), 4.0 / 3.0, 1e-14);
  EXPECT_NEAR(fit.covariance(1, 1), 8.0 / 3.0, 1e-14);
  EXPECT_NEAR(fit.covariance(0, 1), -4.0 / 3.0, 1e-14);
  EXPECT_NEAR(fit.log_likelihood.value(), 2.0 * (std::log(0.25) + 3.0 * std::log(0.75)), 1e-14);
  EXPECT_NEAR(fit.deviance.value(), -2.0 * fit.log_likelihood.value(), 1e-14);
  EXPECT_NEAR(fit.null_deviance.value(), -2.0 * 8.0 * std::log(0.5), 1e-14);
  EXPECT_EQ(fit.df_residual, 6U);
}

}  // namespace
}  // namespace tcert
