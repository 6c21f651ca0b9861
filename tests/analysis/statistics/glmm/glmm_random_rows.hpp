#pragma once
// Random data for mixed models, and derivatives by differences.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <statistics/logistic/binomial_likelihood.hpp>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {

/// Rows in random groups; the first column is the intercept. Groups differ by a shift.
struct RandomRows {
  Eigen::MatrixXd design;
  BinomialRows rows;
  std::vector<std::uint32_t> codes;

  RandomRows(std::uint64_t seed,
             Eigen::Index size,
             std::uint32_t groups,
             Eigen::Index columns,
             bool counts) {
    table::RandomStream stream(seed, 9, 0);
    design.setOnes(size, columns);
    rows.successes.resize(size);
    rows.trials.setOnes(size);
    rows.offset.resize(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 1; j < columns; ++j) {
        design(i, j) = stream.normal();
      }
      const auto group = static_cast<std::uint32_t>(i) % groups;
      codes.push_back(group);
      rows.offset[i] = 0.2 * stream.normal();
      if (counts) {
        rows.trials[i] = 1.0 + std::floor(4.0 * stream.uniform());
      }
      const double eta = 0.3 + 0.8 * std::sin(3.0 * group) + rows.offset[i] +
                         (columns > 1 ? 0.5 * design(i, 1) : 0.0);
      rows.successes[i] = 0.0;
      for (int trial = 0; trial < static_cast<int>(rows.trials[i]); ++trial) {
        rows.successes[i] += stream.uniform() < 1.0 / (1.0 + std::exp(-eta)) ? 1.0 : 0.0;
      }
    }
  }
};

/// Gradient and Hessian against central differences of fourth order of the value and the gradient.
inline void expect_derivatives(MixedLikelihood& likelihood,
                               const Eigen::VectorXd& at,
                               double gradient_tolerance,
                               double hessian_tolerance) {
  LikelihoodPoint here;
  ASSERT_TRUE(likelihood.evaluate(at, Derivatives::hessian, here));
  const double step = 1e-3;
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    double slope = 0.0;
    Eigen::VectorXd column = Eigen::VectorXd::Zero(at.size());
    for (const auto& [shift, weight] :
         {std::pair{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
      Eigen::VectorXd moved = at;
      moved[j] += shift * step;
      LikelihoodPoint there;
      ASSERT_TRUE(likelihood.evaluate(moved, Derivatives::gradient, there));
      slope += weight * there.value / (12.0 * step);
      column += weight * there.gradient / (12.0 * step);
    }
    EXPECT_NEAR(here.gradient[j], slope, gradient_tolerance * (1.0 + std::abs(slope))) << j;
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      EXPECT_NEAR(here.hessian(k, j), column[k], hessian_tolerance * (1.0 + std::abs(column[k])))
          << k << " " << j;
    }
  }
}

}  // namespace tcert::statistics
