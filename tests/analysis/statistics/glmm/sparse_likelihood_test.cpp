// The Laplace likelihood of any random terms: against the other kernel where both apply, and its
// derivatives by differences.

#include <statistics/glmm/sparse_likelihood.hpp>

#include <gtest/gtest.h>

#include <statistics/glmm/intercept_likelihood.hpp>
#include <statistics/glmm/selected_inverse.hpp>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <string>
#include <vector>
#include "analysis/statistics/glmm/glmm_random_rows.hpp"

namespace tcert::statistics {
namespace {

/// Effects of the first `columns` columns of the design, row i in group codes[i].
TermRows term_of(const RandomRows& data,
                 const std::vector<std::uint32_t>& codes,
                 std::uint32_t groups,
                 Eigen::Index columns) {
  TermRows term;
  term.group = "g";
  term.columns.resize(static_cast<std::size_t>(columns), "x");
  term.levels.resize(groups, "level");
  term.codes = codes;
  term.design = data.design.leftCols(columns);
  term.scale = Eigen::VectorXd::Ones(columns);
  return term;
}

/// Groups that cross those of the data.
std::vector<std::uint32_t> crossing(std::size_t rows, std::uint32_t groups) {
  std::vector<std::uint32_t> codes;
  for (std::size_t i = 0; i < rows; ++i) {
    codes.push_back(static_cast<std::uint32_t>((i * i + i / 7) % groups));
  }
  return codes;
}

TEST(SelectedInverse, EqualsTheInverseWhereTheFactorIs) {
  table::RandomStream random(1, 9, 1);
  Eigen::MatrixXd dense = 6.0 * Eigen::MatrixXd::Identity(12, 12);
  for (int k = 0; k < 14; ++k) {
    const auto a = static_cast<Eigen::Index>(random.below(12));
    const auto b = static_cast<Eigen::Index>(random.below(12));
    dense(a, b) += a == b ? 1.0 : 0.3;
    dense(b, a) = dense(a, b);
  }
  const Eigen::SparseMatrix<double> matrix = dense.sparseView();
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      cholesky(matrix);
  const Eigen::SparseMatrix<double> factor = cholesky.matrixL();
  const std::vector<double> found = selected_inverse(factor);
  const Eigen::MatrixXd inverse = dense.inverse();
  std::size_t k = 0;
  for (Eigen::Index column = 0; column < factor.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(factor, column); it; ++it) {
      EXPECT_NEAR(found[k++], inverse(it.row(), it.col()), 1e-14);
    }
  }
}

TEST(SparseLikelihood, EqualsTheOtherKernelOnOneIntercept) {
  const RandomRows data(6, 90, 7, 3, true);
  const std::vector<TermRows> terms{term_of(data, data.codes, 7, 1)};
  SparseLikelihood sparse(data.design, data.rows, terms);
  const GroupedRows grouped = grouped_rows(data.design, data.rows, data.codes, 7);
  InterceptLikelihood scalar(grouped, 1);
  Eigen::VectorXd p(4);
  p << 0.9, 0.2, 0.4, -0.3;
  LikelihoodPoint a;
  LikelihoodPoint b;
  ASSERT_TRUE(sparse.evaluate(p, Derivatives::hessian, a));
  ASSERT_TRUE(scalar.evaluate(p, Derivatives::hessian, b));
  EXPECT_NEAR(a.value, b.value, 1e-12 * std::abs(b.value));
  EXPECT_LT((a.gradient - b.gradient).norm(), 1e-11 * (1.0 + b.gradient.norm()));
  EXPECT_LT((a.hessian - b.hessian).norm(), 1e-8 * b.hessian.norm());
  EXPECT_LT((sparse.modes(p)[0].modes - scalar.modes(p)[0].modes).norm(), 1e-12);
  EXPECT_LT((sparse.modes(p)[0].sds - scalar.modes(p)[0].sds).norm(), 1e-12);
}

TEST(SparseLikelihood, DerivativesEqualDifferences) {
  for (const bool counts : {false, true}) {
    const RandomRows data(7, 120, 7, 3, counts);
    const auto other = crossing(120, 5);
    const std::vector<std::vector<TermRows>> models{
        {term_of(data, data.codes, 7, 2)},
        {term_of(data, data.codes, 7, 1), term_of(data, other, 5, 1)},
        {term_of(data, data.codes, 7, 3), term_of(data, other, 5, 2)}};
    for (const std::vector<TermRows>& terms : models) {
      SparseLikelihood likelihood(data.design, data.rows, terms);
      Eigen::VectorXd p(likelihood.size());
      for (Eigen::Index j = 0; j < p.size(); ++j) {
        p[j] = 0.5 * std::cos(static_cast<double>(j));
      }
      expect_derivatives(likelihood, p, 1e-7, 1e-6);
    }
  }
}

}  // namespace
}  // namespace tcert::statistics
