#include <statistics/logistic/firth.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <statistics/logistic/firth_likelihood.hpp>
#include <table/random.hpp>

#include "support/data_table.hpp"

namespace tcert::statistics {
namespace {

LogisticInput input_of(const std::string& csv, const std::string& formula) {
  return logistic_input(model_frame(parse_formula(formula), test_support::table_of(csv), {}));
}

/// A design of an intercept, two numbers and their product, with counts.
struct Example {
  Eigen::MatrixXd design;
  BinomialRows rows;
};

Example example(Eigen::Index size) {
  table::RandomStream random(5, 1, 0);
  Example made;
  made.design.resize(size, 4);
  made.rows.successes.resize(size);
  made.rows.trials.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double x = random.normal();
    const double z = random.normal();
    made.design.row(i) << 1.0, x, z, x * z;
    made.rows.trials[i] = 1.0 + random.below(3);
    made.rows.successes[i] = random.below(static_cast<std::uint32_t>(made.rows.trials[i]) + 1);
  }
  return made;
}

/// By definition, with a determinant and a hat matrix.
double slow_value(const Example& e, const Eigen::VectorXd& beta) {
  const Eigen::ArrayXd eta = (e.design * beta).array();
  const Eigen::ArrayXd mu = 1.0 / (1.0 + (-eta).exp());
  const Eigen::ArrayXd w = e.rows.trials.array() * mu * (1.0 - mu);
  const Eigen::MatrixXd information = e.design.transpose() * w.matrix().asDiagonal() * e.design;
  const double log_likelihood = (e.rows.successes.array() * mu.log() +
                                 (e.rows.trials - e.rows.successes).array() * (1.0 - mu).log())
                                    .sum();
  return log_likelihood + 0.5 * std::log(information.determinant());
}

TEST(FirthLikelihood, HasTheDerivativesOfItsValue) {
  const Example e = example(600);  // more than two blocks
  const Eigen::Vector4d beta(0.3, -0.7, 0.4, 0.2);
  const FirthLikelihood at = firth_likelihood(e.design, e.rows, beta);
  EXPECT_NEAR(at.value, slow_value(e, beta), 1e-10 * std::abs(at.value));
  const double step = 1e-5;
  for (Eigen::Index j = 0; j < 4; ++j) {
    Eigen::VectorXd up = beta;
    Eigen::VectorXd down = beta;
    up[j] += step;
    down[j] -= step;
    const FirthLikelihood above = firth_likelihood(e.design, e.rows, up);
    const FirthLikelihood below = firth_likelihood(e.design, e.rows, down);
    EXPECT_NEAR(at.gradient[j], (above.value - below.value) / (2.0 * step), 1e-5);
    const Eigen::VectorXd slope = (above.gradient - below.gradient) / (2.0 * step);
    EXPECT_LT((slope + at.curvature.col(j)).norm(), 1e-6 * at.curvature.col(j).norm());
  }
}

TEST(Firth, OfOneProportionAddsHalfASuccessAndHalfAFailure) {
  // det(X'WX) = n mu (1 - mu): the maximum of mu^(k + 1/2) (1 - mu)^(n - k + 1/2).
  const FirthFit fit = fit_firth(input_of("y\n1\n1\n1\n0\n0\n", "y ~ 1"));
  EXPECT_NEAR(fit.coefficients[0].estimate.value(), std::log(3.5 / 2.5), 1e-14);
  EXPECT_NEAR(fit.fitted[0], 3.5 / 6.0, 1e-15);
  const FirthFit all = fit_firth(input_of("y\n1\n1\n1\n", "y ~ 1"));
  EXPECT_NEAR(all.coefficients[0].estimate.value(), std::log(3.5 / 0.5), 1e-13);
  ASSERT_EQ(all.conditions.size(), 1U);
  EXPECT_EQ(all.conditions[0].kind, ConditionKind::one_class);
  EXPECT_EQ(all.conditions[0].severity, ConditionSeverity::note);
}

TEST(Firth, OfATwoByTwoTableAddsAHalfToEachCell) {
  // a saturated model: log of (3.5 / 0.5) / (1.5 / 2.5), although no failure has x = 1
  const FirthFit fit = fit_firth(input_of("x,y\n1,1\n1,1\n1,1\n0,1\n0,0\n0,0\n", "y ~ x"));
  EXPECT_NEAR(fit.coefficients[1].estimate.value(), std::log((3.5 / 0.5) / (1.5 / 2.5)), 1e-12);
  EXPECT_EQ(fit.separation, Separation::quasi);
  ASSERT_TRUE(has(fit.conditions, ConditionKind::penalised_separation));
  EXPECT_FALSE(has_error(fit.conditions));
  // One test of one column: coefficient, term and whole model are the same.
  EXPECT_DOUBLE_EQ(fit.coefficients[1].test->statistic, fit.terms[0].test->statistic);
  EXPECT_DOUBLE_EQ(fit.coefficients[1].test->statistic, fit.likelihood_ratio->statistic);
}

TEST(Firth, EndsOfTheProfileAreWhereTheTestIsAtItsLevel) {
  const LogisticInput input = input_of(
      "x,z,y\n1,2,0\n2,1,0\n3,4,0\n4,1,1\n5,3,1\n6,2,0\n7,5,1\n8,2,1\n9,1,1\n", "y ~ x + z");
  const FirthFit fit = fit_firth(input);
  const Interval profile = fit.coefficients[1].profile.value();
  for (const double end : {profile.low, profile.high}) {
    // The coefficient is `end` where an offset of end x leaves 0.
    LogisticInput shifted = input;
    shifted.offset = end * input.design.col(1);
    EXPECT_NEAR(fit_firth(shifted).coefficients[1].test->p_value, 0.05, 1e-9);
  }
}

TEST(Firth, CountsAndWeightsAreRepeatedRows) {
  const std::string single = "k,n,x\n3,4,1\n1,2,2\n0,3,3\n2,2,0\n";
  const FirthFit counts = fit_firth(input_of(single, "cbind(k, n - k) ~ x"));
  LogisticInput weighted = input_of("y,x\n1,1\n0,1\n1,2\n0,2\n0,3\n1,0\n", "y ~ x");
  weighted.weights = Eigen::VectorXd(6);
  weighted.weights << 3, 1, 1, 1, 3, 2;
  const FirthFit weights = fit_firth(weighted);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(*counts.coefficients[j].estimate, *weights.coefficients[j].estimate, 1e-12);
    EXPECT_NEAR(counts.coefficients[j].profile->low, weights.coefficients[j].profile->low, 1e-8);
  }
}

TEST(Firth, UnitsAndRowOrderDoNotMatter) {
  const LogisticInput input = input_of(
      "x,z,y\n1,2,0\n2,1,0\n3,4,0\n4,1,1\n5,3,1\n6,2,0\n7,5,1\n8,2,1\n9,1,1\n", "y ~ x + z");
  LogisticInput other = input;
  std::vector<Eigen::Index> order(9);
  std::iota(order.rbegin(), order.rend(), 0);
  other.design = input.design(order, Eigen::all);
  other.successes = input.successes(order);
  other.design.col(1) *= 1e8;
  other.design.col(2) *= 1e-8;
  const FirthFit one = fit_firth(input);
  const FirthFit two = fit_firth(other);
  EXPECT_NEAR(*one.coefficients[1].estimate, *two.coefficients[1].estimate * 1e8, 1e-11);
  EXPECT_NEAR(one.coefficients[2].profile->high, two.coefficients[2].profile->high * 1e-8, 1e-8);
  EXPECT_NEAR(one.coefficients[2].test->p_value, two.coefficients[2].test->p_value, 1e-11);
}

TEST(Firth, NamesColumnsWithoutAnEstimate) {
  const FirthFit fit =
      fit_firth(input_of("x,c,y\n1,2,0\n2,2,1\n3,2,0\n4,2,1\n5,2,1\n", "y ~ x + c"));
  EXPECT_TRUE(has(fit.conditions, ConditionKind::constant_column));
  EXPECT_EQ(fit.coefficients[2].kind, CoefficientKind::not_estimable);
  EXPECT_FALSE(fit.coefficients[2].estimate.has_value());
  EXPECT_TRUE(fit.coefficients[1].estimate.has_value());
  EXPECT_FALSE(fit.terms[1].test.has_value());
  EXPECT_TRUE(has(fit_firth(input_of("x,y\nInf,1\n1,0\n", "y ~ x")).conditions,
                  ConditionKind::infinite_value));
}

}  // namespace
}  // namespace tcert::statistics
