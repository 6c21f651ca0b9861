#include <statistics/logistic/logistic.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {
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

TEST(Logistic, CountsAreRowsPutTogether) {
  const LogisticInput rows = on({0, 0, 0, 0, 1, 1, 1, 1}, {1, 0, 0, 0, 1, 1, 1, 0});
  LogisticInput counts = on({0, 1}, {1, 3});
  counts.trials = Eigen::Vector2d(4, 4);
  LogisticInput weighted = on({0, 0, 1, 1, 5}, {1, 0, 1, 0, 0});
  weighted.weights = (Eigen::VectorXd(5) << 1, 3, 3, 1, 0).finished();
  const LogisticFit a = fit_logistic(rows);
  const LogisticFit b = fit_logistic(counts);
  const LogisticFit c = fit_logistic(weighted);
  EXPECT_NEAR((a.covariance - b.covariance).norm(), 0.0, 1e-14);
  EXPECT_NEAR((a.covariance - c.covariance).norm(), 0.0, 1e-14);
  // The counts' constant: 4 choose 1 and 4 choose 3. The model is saturated.
  EXPECT_NEAR(*b.log_likelihood - *a.log_likelihood, 2.0 * std::log(4.0), 1e-13);
  EXPECT_NEAR(*b.deviance, 0.0, 1e-14);
  EXPECT_EQ(b.df_residual, 0U);
  EXPECT_NEAR(*c.log_likelihood, *a.log_likelihood, 1e-14);
  EXPECT_EQ(c.rows, 4U) << "a row of weight 0 is none";
  EXPECT_EQ(c.fitted.size(), 5);
}

TEST(Logistic, ExtremeUnitsChangeNoTest) {
  const LogisticFit plain = fit_logistic(on({1, 2, 3, 4, 5, 6}, {0, 1, 0, 1, 0, 1}));
  for (const double unit : {1e-200, 1e200}) {
    LogisticInput input = on({1, 2, 3, 4, 5, 6}, {0, 1, 0, 1, 0, 1});
    input.design.col(1) *= unit;
    const LogisticFit fit = fit_logistic(input);
    EXPECT_NEAR(fit.coefficients[1].z.value(), plain.coefficients[1].z.value(), 1e-10);
    EXPECT_NEAR(fit.coefficients[1].p_value.value(), plain.coefficients[1].p_value.value(), 1e-10);
    EXPECT_NEAR(fit.coefficients[1].standard_error.value() * unit,
                plain.coefficients[1].standard_error.value(),
                1e-10);
  }
}

TEST(Logistic, KeepsTheOffsetInTheNullModel) {
  // With an offset of log 3 for the second group the slope is log 3 less; so is the null model's
  // eta for the first group. By symmetry the null intercept is -log(3) / 2.
  LogisticInput input = on({0, 0, 0, 0, 1, 1, 1, 1}, {1, 0, 0, 0, 1, 1, 1, 0});
  input.offset = std::log(3.0) * input.design.col(1);
  const LogisticFit fit = fit_logistic(input);
  EXPECT_NEAR(*fit.coefficients[1].estimate, std::log(3.0), 1e-14);
  const double p = 1.0 / (1.0 + std::sqrt(3.0));
  EXPECT_NEAR(*fit.null_deviance, -4.0 * (std::log(p) + 3.0 * std::log(1.0 - p)), 1e-13);
}

TEST(Logistic, HasTheSandwichOfTheDefinition) {
  LogisticInput input = on({-2, -1, 0, 1, 2, 3, 1, 0}, {0, 1, 0, 0, 1, 1, 1, 0});
  input.cluster = table::Factor{{0, 0, 1, 1, 2, 2, 0, 1}, {"a", "b", "c"}};
  LogisticOptions options;
  options.variance = CoefficientVariance::robust;
  const LogisticFit model = fit_logistic(input);
  const LogisticFit robust = fit_logistic(input, options);
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(3, 2);
  for (Eigen::Index i = 0; i < 8; ++i) {
    scores.row(static_cast<Eigen::Index>(input.cluster->codes[static_cast<std::size_t>(i)])) +=
        (input.successes[i] - model.fitted[i]) * input.design.row(i);
  }
  const Eigen::MatrixXd expected =
      model.covariance * scores.transpose() * scores * model.covariance;
  EXPECT_NEAR((robust.covariance - expected).norm(), 0.0, 1e-13);
  EXPECT_EQ(robust.clusters, 3U);
  EXPECT_TRUE(has(robust.conditions, ConditionKind::few_clusters));

  input.cluster = table::Factor{std::vector<std::uint32_t>(8, 0), {"a"}};
  const LogisticFit one = fit_logistic(input, options);
  EXPECT_TRUE(has(one.conditions, ConditionKind::one_cluster));
  EXPECT_TRUE(one.coefficients[1].estimate.has_value());
  EXPECT_FALSE(one.coefficients[1].standard_error.has_value());
}

TEST(Logistic, NamesColumnsThatSayNothingNew) {
  LogisticInput input = on({1, 2, 3, 4, 5, 6}, {0, 1, 0, 1, 0, 1});
  input.design.conservativeResize(6, 4);
  input.design.col(2).setConstant(7.0);
  input.design.col(3) = 3.0 * input.design.col(1).array() - 1.0;
  input.columns = {"(Intercept)", "x", "seven", "twin"};
  input.term_of = {0, 1, 2, 3};
  input.terms = {"x", "seven", "twin"};
  const LogisticFit fit = fit_logistic(input);
  ASSERT_EQ(fit.conditions.size(), 2U);
  EXPECT_EQ(fit.conditions[0].kind, ConditionKind::constant_column);
  EXPECT_EQ(fit.conditions[0].column, "seven");
  EXPECT_EQ(fit.conditions[1].kind, ConditionKind::collinear_column);
  EXPECT_EQ(fit.conditions[1].column, "twin");
  EXPECT_EQ(fit.coefficients[3].kind, CoefficientKind::not_estimable);
  EXPECT_EQ(fit.rank, 2U);
  const LogisticFit plain = fit_logistic(on({1, 2, 3, 4, 5, 6}, {0, 1, 0, 1, 0, 1}));
  EXPECT_EQ(fit.coefficients[1].estimate, plain.coefficients[1].estimate);
}

TEST(Logistic, NamesWhatItCannotFit) {
  EXPECT_TRUE(has(fit_logistic(on({}, {})).conditions, ConditionKind::no_rows));
  EXPECT_TRUE(has(fit_logistic(on({1}, {1})).conditions, ConditionKind::one_class));
  EXPECT_TRUE(has(fit_logistic(on({1, 2}, {0, 0})).conditions, ConditionKind::one_class));
  EXPECT_TRUE(has(fit_logistic(on({1, 2}, {0, 1})).conditions, ConditionKind::complete_separation));
  LogisticInput three = on({1, 2}, {0, 1});
  three.design = Eigen::MatrixXd::Random(2, 3);
  three.columns = {"a", "b", "c"};
  three.term_of = {1, 2, 3};
  three.terms = three.columns;
  EXPECT_TRUE(has(fit_logistic(three).conditions, ConditionKind::too_few_rows));
  LogisticInput infinite = on({1, 2, INFINITY}, {0, 1, 0});
  EXPECT_TRUE(has(fit_logistic(infinite).conditions, ConditionKind::infinite_value));
  LogisticOptions few;
  few.newton.max_iterations = 1;
  const LogisticFit stopped = fit_logistic(on({0, 0, 0, 0, 1, 1, 2}, {1, 0, 0, 0, 1, 1, 0}), few);
  EXPECT_TRUE(has(stopped.conditions, ConditionKind::not_converged));
  EXPECT_FALSE(stopped.coefficients[0].estimate.has_value());
}

TEST(Logistic, FitsNothingButAnOffset) {
  LogisticInput input = on({1, 2, 3}, {0, 1, 0});
  input.design.resize(3, 0);
  input.columns.clear();
  input.term_of.clear();
  input.terms.clear();
  const LogisticFit fit = fit_logistic(input);
  EXPECT_NEAR(fit.deviance.value(), -6.0 * std::log(0.5), 1e-14);
  EXPECT_EQ(fit.deviance, fit.null_deviance);
}

TEST(Logistic, RefusesMisuse) {
  EXPECT_THROW(static_cast<void>(fit_logistic(on({1, 2}, {0, 2}))), std::invalid_argument);
  LogisticInput input = on({1, 2}, {0, 1});
  input.offset = Eigen::VectorXd::Zero(3);
  EXPECT_THROW(static_cast<void>(fit_logistic(input)), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
