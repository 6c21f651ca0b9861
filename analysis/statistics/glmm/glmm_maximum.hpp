#pragma once
/// \file
/// The maximum of the likelihood of a mixed model: a search by Ceres, then Newton's method.
/// Internal to the estimator.

#include <Eigen/Core>
#include <optional>
#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <vector>

namespace tcert::statistics {

struct GlmmMaximum {
  GlmmTermination termination = GlmmTermination::converged;
  Eigen::VectorXd parameters;
  LikelihoodPoint at;
  int iterations = 0;
  int evaluations = 0;
  double last_step = 0.0;  ///< In standard errors.

  [[nodiscard]] bool converged() const noexcept {
    return termination == GlmmTermination::converged;
  }
};

/// Parameters nearer to the maximum: quasi-Newton steps (BFGS with a Wolfe line search, Ceres) in
/// the metric of the Hessian at `start`, until the gradient in standard errors is below
/// `gradient_tolerance`, or that at the start times `relative_tolerance`. Where it cannot go on it
/// returns what it has. Adds to `iterations` and `evaluations`.
[[nodiscard]] Eigen::VectorXd search_maximum(MixedLikelihood& likelihood,
                                             const Eigen::VectorXd& start,
                                             double gradient_tolerance,
                                             double relative_tolerance,
                                             int& iterations,
                                             int& evaluations);

/// Newton's method over `start` + span(`subspace`) (columns orthonormal; empty: everywhere), with
/// steps halved until the likelihood does not fall and away from saddles. Converged when a step
/// with a negative definite Hessian is shorter than `step_tolerance` in standard errors; that step
/// is still taken. A factor's element beyond 1000 is divergence.
[[nodiscard]] GlmmMaximum newton_maximum(MixedLikelihood& likelihood,
                                         const Eigen::VectorXd& start,
                                         const std::optional<Eigen::MatrixXd>& subspace,
                                         const GlmmOptions& options);

/// No eigenvalue is above rounding.
[[nodiscard]] bool is_concave(const Eigen::MatrixXd& hessian);

/// The columns of the identity whose place is not `fixed`.
[[nodiscard]] Eigen::MatrixXd free_directions(const std::vector<bool>& fixed);

}  // namespace tcert::statistics
