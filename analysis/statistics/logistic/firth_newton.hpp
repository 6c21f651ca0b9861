#pragma once
/// \file
/// Newton's method on Firth's penalised likelihood, over all coefficients or a subspace of them.

#include <Eigen/Core>
#include <optional>
#include <statistics/logistic/firth_likelihood.hpp>
#include <statistics/logistic/newton_ascent.hpp>

namespace tcert::statistics {

using FirthNewtonResult = NewtonAscent<FirthLikelihood>;

/// Maximises from `start` over start + span(`subspace`), or without one over everything. Steps are
/// Newton's with the exact Hessian; where that is not negative definite, with the information, as
/// Firth scoring takes them. \pre the columns of `design` are orthonormal.
/// O(rows columns^3) an iteration.
[[nodiscard]] FirthNewtonResult maximise_firth(const Eigen::MatrixXd& design,
                                               const BinomialRows& rows,
                                               const Eigen::VectorXd& start,
                                               const std::optional<Eigen::MatrixXd>& subspace,
                                               const NewtonOptions& options);

}  // namespace tcert::statistics
