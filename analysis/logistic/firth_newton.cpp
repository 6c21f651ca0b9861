#include "analysis/logistic/firth_newton.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

namespace tcert {
namespace {

struct Step {
  Eigen::VectorXd direction;
  double length = 0.0;  ///< In standard errors: the Newton decrement.
};

std::optional<Step> step_by(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& gradient) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(curvature);
  if (cholesky.info() != Eigen::Success) {
    return std::nullopt;
  }
  Eigen::VectorXd direction = cholesky.solve(gradient);
  const double decrement = gradient.dot(direction);
  if (!std::isfinite(decrement)) {
    return std::nullopt;
  }
  return Step{std::move(direction), std::sqrt(std::max(0.0, decrement))};
}

std::optional<Step> newton_step(const FirthLikelihood& at,
                                const std::optional<Eigen::MatrixXd>& subspace) {
  if (!std::isfinite(at.value)) {
    return std::nullopt;
  }
  if (!subspace) {
    const auto exact = step_by(at.curvature, at.gradient);
    return exact ? exact : step_by(at.information, at.gradient);
  }
  if (subspace->cols() == 0) {
    return Step{Eigen::VectorXd::Zero(at.gradient.size()), 0.0};
  }
  const auto within = [&](const Eigen::MatrixXd& curvature) {
    return step_by(subspace->transpose() * curvature * *subspace,
                   subspace->transpose() * at.gradient);
  };
  std::optional<Step> step = within(at.curvature);
  if (!step) {
    step = within(at.information);
  }
  if (step) {
    step->direction = *subspace * step->direction;
  }
  return step;
}

/// True if `now` is no worse than `before`, up to the rounding of sums of such size.
bool no_worse(double now, double before) {
  return now >= before - 1e-13 * (1.0 + std::abs(before));
}

}  // namespace

FirthNewtonResult maximise_firth(const Eigen::MatrixXd& design,
                                 const BinomialRows& rows,
                                 const Eigen::VectorXd& start,
                                 const std::optional<Eigen::MatrixXd>& subspace,
                                 const NewtonOptions& options) {
  FirthNewtonResult result;
  result.coefficients = start;
  result.at = firth_likelihood(design, rows, start);
  while (true) {
    const std::optional<Step> step = newton_step(result.at, subspace);
    if (!step) {
      result.termination = Termination::singular;
      return result;
    }
    result.last_step = step->length;
    const bool last = step->length <= options.step_tolerance;
    if (!last && result.iterations == options.max_iterations) {
      result.termination = Termination::iteration_limit;
      return result;
    }
    double scale = 1.0;
    Eigen::VectorXd next = result.coefficients + step->direction;
    FirthLikelihood at = firth_likelihood(design, rows, next);
    for (int halving = 0; !no_worse(at.value, result.at.value); ++halving) {
      if (halving == options.max_halvings) {
        result.termination = Termination::no_ascent;
        return result;
      }
      scale *= 0.5;
      next = result.coefficients + scale * step->direction;
      at = firth_likelihood(design, rows, next);
    }
    ++result.iterations;
    result.coefficients = std::move(next);
    result.at = std::move(at);
    if (last) {
      return result;
    }
  }
}

}  // namespace tcert
