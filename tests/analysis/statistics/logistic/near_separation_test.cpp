#include <statistics/logistic/near_separation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <statistics/basics/runaway.hpp>
#include <statistics/logistic/logistic_profile.hpp>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

LogisticInput line(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  LogisticInput input;
  input.design = Eigen::MatrixXd::Ones(n, 2);
  input.design.col(1) = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
  input.columns = {"(Intercept)", "x"};
  input.terms = {"x"};
  input.term_of = {0, 1};
  input.successes = Eigen::Map<const Eigen::VectorXd>(y.data(), n);
  return input;
}

/// 0, 1, ... in steps, failures first; two neighbours in the middle change places by `overlap`.
LogisticInput nearly_separated(std::size_t n, double step, double overlap) {
  std::vector<double> x(n);
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = step * static_cast<double>(i);
    y[i] = i < n / 2 ? 0.0 : 1.0;
  }
  x[n / 2 - 1] = x[n / 2] + overlap;
  return line(x, y);
}

TEST(NearSeparation, TypicalSpreadIsMovedByNoOutlier) {
  EXPECT_NEAR(typical_spread({0, 1, 2, 3, 4}), 2.0 / 1.349, 1e-12);
  EXPECT_NEAR(typical_spread({0, 1, 2, 3, 1e9}), 2.0 / 1.349, 1e-12);
  EXPECT_EQ(typical_spread({0, 0, 0, 0, 0, 0, 0, 0, 0, 1}), 1.0);
  EXPECT_EQ(typical_spread({0, 0, 1, 1}), 1.0) << "a dummy, whatever its share";
  EXPECT_EQ(typical_spread({1, 0, 1, 1, 0, 1, 0, 1}), 1.0);
  EXPECT_EQ(typical_spread({5, 5, 5, 5, 5, 5, 5, 5, 5, 2, 9, 8}), 3.0);
  EXPECT_EQ(typical_spread({7, 7, 7}), 0.0);
  EXPECT_EQ(typical_spread({}), 0.0);
}

/// What is ruled out by the range alone is ruled out by any spread.
TEST(NearSeparation, IsRuledOutByTheRange) {
  EXPECT_FALSE(may_have_run_away({-34.0, 10.0}));
  EXPECT_TRUE(may_have_run_away({-34.1, 0.1}));
  EXPECT_TRUE(may_have_run_away({0.0, 10.1}));
  for (const std::vector<double>& values :
       std::vector<std::vector<double>>{{0, 1},
                                        {0, 0, 0, 1},
                                        {3, -4, 8, 1e9, 2},
                                        {5, 5, 5, 5, 5, 2, 9},
                                        {0, 0, 10, 10, 10, 9}}) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_LE(typical_spread(values), *high - *low);
  }
}

TEST(NearSeparation, IsToldFromCollinearityByTheErrorWithoutEffect) {
  EXPECT_TRUE(has_run_away({10.0, 60.0, 0.3}, 40.0)) << "flatter than one trial";
  EXPECT_FALSE(has_run_away({10.0, 60.0, 55.0}, 40.0)) << "as flat without effect";
  EXPECT_FALSE(has_run_away({5.0, 9.0, 0.3}, 40.0)) << "a wide interval, no more";
  EXPECT_TRUE(has_run_away({107.0, 9.0, 0.01}, 1e4)) << "an odds ratio of 3e46 per spread";
  EXPECT_FALSE(has_run_away({-200.0, 100.0, 90.0}, 400.0));
}

TEST(NearSeparation, LeavesNoEstimateButTheLimitTowardsNought) {
  const LogisticInput input = nearly_separated(40, 0.025, 1e-5);
  const LogisticFit fit = fit_logistic(input);
  EXPECT_EQ(fit.separation, Separation::none);
  EXPECT_EQ(fit.coefficients[1].kind, CoefficientKind::ran_away);
  EXPECT_FALSE(fit.coefficients[1].estimate.has_value());
  EXPECT_FALSE(fit.coefficients[1].interval.has_value());
  EXPECT_FALSE(fit.coefficients[0].estimate.has_value()) << "the threshold's slope is its scale";
  EXPECT_TRUE(std::isnan(fit.covariance(1, 1)));
  EXPECT_TRUE(fit.log_likelihood.has_value()) << "a maximum there is";
  EXPECT_TRUE(has(fit.conditions, ConditionKind::near_separation));
  EXPECT_FALSE(has_error(fit.conditions));
  const ProfileLimits limits = profile_limits(input)[1];
  EXPECT_GT(limits.low.value(), 10.0);
  EXPECT_LT(limits.low.value(), 1000.0);
  EXPECT_TRUE(limits.open_high);
}

TEST(NearSeparation, DoesNotDependOnUnits) {
  for (const double unit : {1e-150, 1e-3, 1e3, 1e150}) {
    LogisticInput input = nearly_separated(40, 0.025, 1e-5);
    input.design.col(1) *= unit;
    EXPECT_EQ(fit_logistic(input).coefficients[1].kind, CoefficientKind::ran_away) << unit;
    LogisticInput plain = line({1, 2, 3, 4, 5, 6}, {0, 1, 0, 1, 0, 1});
    plain.design.col(1) *= unit;
    EXPECT_EQ(fit_logistic(plain).coefficients[1].kind, CoefficientKind::finite) << unit;
  }
}

TEST(NearSeparation, SpeaksOfNothingElse) {
  // An outlier whose probability is numerically 1, as in R's warning; a steep and well known slope;
  // two columns that are nearly one; an intercept far outside of the data.
  table::RandomStream random(5, 1, 0);
  const Eigen::Index n = 400;
  std::vector<double> x;
  std::vector<double> y;
  for (Eigen::Index i = 0; i < n; ++i) {
    x.push_back(random.normal());
    y.push_back(random.uniform() < 1.0 / (1.0 + std::exp(-x.back())) ? 1.0 : 0.0);
  }
  x[0] = 1e6;
  y[0] = 1.0;
  const LogisticFit outlier = fit_logistic(line(x, y));
  EXPECT_EQ(outlier.coefficients[1].kind, CoefficientKind::finite);
  EXPECT_GT(outlier.fitted[0], 1.0 - 1e-12);

  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    x[at] = 2020.0 + random.normal();
    y[at] = random.uniform() < 1.0 / (1.0 + std::exp(-8.0 * (x[at] - 2020.0))) ? 1.0 : 0.0;
  }
  LogisticInput steep = line(x, y);
  EXPECT_EQ(fit_logistic(steep).coefficients[1].kind, CoefficientKind::finite);
  EXPECT_EQ(fit_logistic(steep).coefficients[0].kind, CoefficientKind::finite);
  steep.design.conservativeResize(Eigen::NoChange, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    steep.design(i, 2) = steep.design(i, 1) + 1e-3 * random.normal();
  }
  steep.columns.emplace_back("near");
  steep.terms.emplace_back("near");
  steep.term_of.push_back(2);
  const LogisticFit collinear = fit_logistic(steep);
  EXPECT_EQ(collinear.coefficients[2].kind, CoefficientKind::finite);
  EXPECT_GT(collinear.coefficients[2].standard_error.value(), 100.0);
}

}  // namespace
}  // namespace tcert::statistics
