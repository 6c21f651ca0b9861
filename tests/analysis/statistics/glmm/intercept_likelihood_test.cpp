// The likelihood of a single random intercept: by a slow second way, and its derivatives by
// differences.

#include <statistics/glmm/intercept_likelihood.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>
#include "analysis/statistics/glmm/glmm_random_rows.hpp"

namespace tcert::statistics {
namespace {

/// log of the integral over u of a group, by the trapezoidal rule on a fine fixed grid.
double integral(const GroupedRows& rows, std::size_t g, const Eigen::VectorXd& p) {
  const double step = 0.01;
  double sum = 0.0;
  for (double u = -12.0; u < 12.0; u += step) {
    double density = std::exp(-0.5 * u * u) / std::sqrt(2.0 * M_PI);
    for (Eigen::Index i = rows.start[g]; i < rows.start[g + 1]; ++i) {
      const double eta = rows.basis.row(i).dot(p.tail(p.size() - 1)) + rows.offset[i] + p[0] * u;
      const double success = 1.0 / (1.0 + std::exp(-eta));
      density *= std::pow(success, rows.successes[i]) *
                 std::pow(1.0 - success, rows.trials[i] - rows.successes[i]);
    }
    sum += step * density;
  }
  return std::log(sum);
}

GroupedRows random_rows(std::uint64_t seed, bool counts, Eigen::Index columns = 3) {
  const RandomRows data(seed, 80, 7, columns, counts);
  return grouped_rows(data.design, data.rows, data.codes, 7);
}

Eigen::VectorXd parameters(Eigen::Index size, double theta) {
  Eigen::VectorXd p(size);
  for (Eigen::Index j = 0; j < size; ++j) {
    p[j] = 0.3 * std::cos(static_cast<double>(2 * j + 1));
  }
  p[0] = theta;
  return p;
}

TEST(InterceptLikelihood, ManyPointsEqualTheIntegral) {
  for (const bool counts : {false, true}) {
    const GroupedRows rows = random_rows(1, counts);
    const Eigen::VectorXd p = parameters(4, 0.8);
    double expected = 0.0;
    for (std::size_t g = 0; g < 7; ++g) {
      expected += integral(rows, g, p);
    }
    InterceptLikelihood likelihood(rows, 40);
    LikelihoodPoint point;
    ASSERT_TRUE(likelihood.evaluate(p, Derivatives::none, point));
    EXPECT_NEAR(point.value, expected, 1e-10 * std::abs(expected));
  }
}

TEST(InterceptLikelihood, NoVarianceIsThePlainLikelihood) {
  const RandomRows data(3, 80, 7, 3, true);
  const GroupedRows rows = grouped_rows(data.design, data.rows, data.codes, 7);
  const Eigen::VectorXd p = parameters(4, 0.0);
  for (const int quadrature : {1, 9}) {
    InterceptLikelihood likelihood(rows, quadrature);
    LikelihoodPoint point;
    ASSERT_TRUE(likelihood.evaluate(p, Derivatives::hessian, point));
    const BinomialLikelihood plain = binomial_likelihood(data.design, data.rows, p.tail(3));
    EXPECT_NEAR(point.value, plain.log_likelihood, 1e-12 * std::abs(plain.log_likelihood));
    EXPECT_NEAR(point.gradient[0], 0.0, 1e-12);
    EXPECT_LT((point.gradient.tail(3) - plain.gradient).norm(), 1e-12 * plain.gradient.norm());
    EXPECT_LT((point.hessian.bottomRightCorner(3, 3) + plain.information).norm(),
              1e-12 * plain.information.norm());
  }
}

TEST(InterceptLikelihood, DerivativesEqualDifferences) {
  for (const bool counts : {false, true}) {
    for (const int quadrature : {1, 2, 5, 25}) {
      for (const double theta : {-0.7, 0.0, 0.3, 2.0}) {
        SCOPED_TRACE(testing::Message() << counts << " " << quadrature << " " << theta);
        const GroupedRows rows = random_rows(2, counts);
        InterceptLikelihood likelihood(rows, quadrature);
        expect_derivatives(likelihood, parameters(4, theta), 1e-7, 1e-7);
      }
    }
  }
}

TEST(InterceptLikelihood, IsEvenInTheta) {
  const GroupedRows rows = random_rows(4, false);
  InterceptLikelihood likelihood(rows, 6);
  LikelihoodPoint plus;
  LikelihoodPoint minus;
  ASSERT_TRUE(likelihood.evaluate(parameters(4, 1.1), Derivatives::gradient, plus));
  ASSERT_TRUE(likelihood.evaluate(parameters(4, -1.1), Derivatives::gradient, minus));
  EXPECT_NEAR(plus.value, minus.value, 1e-12 * std::abs(plus.value));
  EXPECT_NEAR(plus.gradient[0], -minus.gradient[0], 1e-10);
}

TEST(InterceptLikelihood, RefusesWhatOverflows) {
  const GroupedRows rows = random_rows(5, false);
  InterceptLikelihood likelihood(rows, 3);
  LikelihoodPoint point;
  EXPECT_FALSE(likelihood.evaluate(1e4 * parameters(4, 0.5), Derivatives::none, point));
  EXPECT_FALSE(likelihood.evaluate(parameters(4, std::nan("")), Derivatives::none, point));
  EXPECT_TRUE(likelihood.evaluate(parameters(4, 0.5), Derivatives::none, point));
}

}  // namespace
}  // namespace tcert::statistics
