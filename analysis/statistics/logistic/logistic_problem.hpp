#pragma once
/// \file
/// A logistic regression made ready to be solved, and its maximum: what the fit, its profile and
/// its tests share.

#include <Eigen/Core>
#include <statistics/logistic/binomial_newton.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/orthonormal_basis.hpp>
#include <statistics/logistic/separation.hpp>
#include <vector>

namespace tcert::statistics {

/// The rows with trials and weight, over an orthonormal basis of the design.
struct LogisticProblem {
  std::vector<Eigen::Index> used;  ///< Rows of the input.
  OrthonormalBasis space;
  BinomialRows rows;  ///< Weights multiplied in.
  double log_coefficients = 0.0;
  double saturated = 0.0;

  [[nodiscard]] Eigen::Index size() const noexcept { return space.basis.rows(); }
};

[[nodiscard]] LogisticProblem logistic_problem(const LogisticInput& input);

/// Only the rows for which `keep` (one a row of the problem) holds, over their own basis; its
/// columns count among the kept ones of `problem`.
[[nodiscard]] LogisticProblem part_of(const LogisticInput& input,
                                      const LogisticProblem& problem,
                                      const std::vector<bool>& keep);

/// Where to start: 0, or against a large offset, where 0 may be hopelessly far, the least-squares
/// fit of the rows' own smoothed logits less the offset (as `glm` starts).
[[nodiscard]] Eigen::VectorXd starting_point(const LogisticProblem& problem);

/// The maximum, or under separation the supremum.
struct LogisticMaximum {
  NewtonResult newton;  ///< Of the whole problem, or of `limit` under separation.
  SeparationResult separation;
  LogisticProblem limit;  ///< Under separation: the rows that overlap; its columns count among
                          ///< the kept ones of the whole problem.

  /// The problem that `newton` solved.
  [[nodiscard]] const LogisticProblem& solved(const LogisticProblem& problem) const noexcept {
    return separation.kind == Separation::none ? problem : limit;
  }
};

[[nodiscard]] LogisticMaximum maximum_of(const LogisticInput& input,
                                         const LogisticProblem& problem,
                                         const NewtonOptions& options);

/// Row k: what the k-th kept coefficient is of the coefficients along the basis.
[[nodiscard]] Eigen::MatrixXd inverse_triangle(const OrthonormalBasis& space);

}  // namespace tcert::statistics
