#pragma once
/// \file
/// Newton's method (which for a logit link is iteratively reweighted least squares) on the
/// binomial log-likelihood, over all coefficients or a subspace of them.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <statistics/logistic/binomial_likelihood.hpp>
#include <statistics/logistic/newton_ascent.hpp>

namespace tcert::statistics {

using NewtonResult = NewtonAscent<BinomialLikelihood>;

/// A linear predictor beyond this is a fitted probability within 1e-6 of 0 or 1: a sign of
/// separation, no proof.
inline constexpr double kSuspiciousEta = 13.8;

/// Asked at most once, when a linear predictor first exceeds `kSuspiciousEta`: true ends the fit.
using DivergenceTest = std::function<bool()>;

/// Maximises from `start` over start + span(`subspace`), or without one over everything.
/// With an orthonormal `design` scales and correlations of the columns do not matter.
/// O(rows columns^2) an iteration.
[[nodiscard]] NewtonResult maximise_binomial(const Eigen::MatrixXd& design,
                                             const BinomialRows& rows,
                                             const Eigen::VectorXd& start,
                                             const std::optional<Eigen::MatrixXd>& subspace,
                                             const NewtonOptions& options,
                                             const DivergenceTest& diverges = nullptr);

}  // namespace tcert::statistics
