#pragma once
/// \file
/// Newton's method with halved steps, for any concave log-likelihood that states its own step.

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace tcert::statistics {

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

struct NewtonStep {
  Eigen::VectorXd direction;
  double length = 0.0;  ///< In standard errors: the Newton decrement.
};

/// `Likelihood` is what is raised and its derivatives at a point.
template <class Likelihood>
struct NewtonAscent {
  Termination termination = Termination::converged;
  int iterations = 0;  ///< Steps taken.
  Eigen::VectorXd coefficients;
  Likelihood at;           ///< At `coefficients`.
  double last_step = 0.0;  ///< Its length in standard errors.

  [[nodiscard]] bool converged() const noexcept { return termination == Termination::converged; }
};

/// Raises the member `value` of `likelihood(coefficients)` from `start`. `step_from(likelihood)` is
/// the step from there, or nothing if the information is singular; `diverging(likelihood)` ends
/// the ascent. A step is halved until the value is no worse, up to the rounding of such sums.
template <class Likelihood, class LikelihoodAt, class StepFrom, class Diverging>
[[nodiscard]] NewtonAscent<Likelihood> newton_ascent(const Eigen::VectorXd& start,
                                                     const NewtonOptions& options,
                                                     double Likelihood::*value,
                                                     const LikelihoodAt& likelihood,
                                                     const StepFrom& step_from,
                                                     const Diverging& diverging) {
  const auto no_worse = [](double now, double before) {
    return now >= before - 1e-13 * (1.0 + std::abs(before));
  };
  NewtonAscent<Likelihood> result;
  const auto ended = [&result](Termination why) {
    result.termination = why;
    return result;
  };
  result.coefficients = start;
  result.at = likelihood(start);
  while (true) {
    if (diverging(result.at)) {
      return ended(Termination::diverging);
    }
    const std::optional<NewtonStep> step = step_from(result.at);
    if (!step) {
      return ended(Termination::singular);
    }
    result.last_step = step->length;
    const bool last = step->length <= options.step_tolerance;
    if (!last && result.iterations == options.max_iterations) {
      return ended(Termination::iteration_limit);
    }
    double scale = 1.0;
    Eigen::VectorXd next = result.coefficients + step->direction;
    Likelihood at = likelihood(next);
    for (int halving = 0; !no_worse(at.*value, result.at.*value); ++halving) {
      if (halving == options.max_halvings) {
        return ended(Termination::no_ascent);
      }
      scale *= 0.5;
      next = result.coefficients + scale * step->direction;
      at = likelihood(next);
    }
    ++result.iterations;
    result.coefficients = std::move(next);
    result.at = std::move(at);
    if (last) {
      return result;
    }
  }
}

}  // namespace tcert::statistics
