#pragma once
/// \file
/// Newton's method (which for a logit link is iteratively reweighted least squares) on the
/// binomial log-likelihood, over all coefficients or a subspace of them.

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "analysis/logistic/binomial_likelihood.hpp"

namespace tcert {

struct NewtonOptions {
  int max_iterations = 100;
  /// Converged when a step is shorter than this, measured in standard errors; that step is still
  /// taken, and as convergence is quadratic nothing is left beyond rounding.
  double step_tolerance = 1e-8;
  int max_halvings = 40;  ///< Of one step that would lower the log-likelihood.
};

enum class Termination : std::uint8_t {
  converged,
  diverging,  ///< The caller's test of divergence said so.
  iteration_limit,
  no_ascent,  ///< No step raises the log-likelihood, but the gradient is not 0.
  singular,   ///< The information cannot be inverted.
};

/// "converged", "diverging", "iteration limit", "no ascent", "singular information".
[[nodiscard]] std::string_view to_string(Termination termination) noexcept;

struct NewtonResult {
  Termination termination = Termination::converged;
  int iterations = 0;  ///< Steps taken.
  Eigen::VectorXd coefficients;
  BinomialLikelihood at;   ///< At `coefficients`.
  double last_step = 0.0;  ///< Its length in standard errors.

  [[nodiscard]] bool converged() const noexcept { return termination == Termination::converged; }
};

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

}  // namespace tcert
