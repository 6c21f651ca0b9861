#include "analysis/logistic/binomial_newton.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <optional>
#include <utility>

namespace tcert {
namespace {

struct Step {
  Eigen::VectorXd direction;
  double length = 0.0;  ///< In standard errors: the Newton decrement.
};

/// False if a pivot is nothing but rounding: a direction that no row with trials looks along.
bool invertible(const Eigen::LLT<Eigen::MatrixXd>& cholesky) {
  const Eigen::VectorXd pivots = Eigen::MatrixXd(cholesky.matrixLLT()).diagonal().cwiseAbs2();
  return pivots.minCoeff() > 1e-14 * pivots.maxCoeff();
}

std::optional<Step> newton_step(const BinomialLikelihood& at,
                                const std::optional<Eigen::MatrixXd>& subspace) {
  const Eigen::VectorXd gradient =
      subspace ? Eigen::VectorXd(subspace->transpose() * at.gradient) : at.gradient;
  const Eigen::MatrixXd information =
      subspace ? Eigen::MatrixXd(subspace->transpose() * at.information * *subspace)
               : at.information;
  if (gradient.size() == 0) {
    return Step{Eigen::VectorXd::Zero(at.gradient.size()), 0.0};
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(information);
  if (cholesky.info() != Eigen::Success || !invertible(cholesky)) {
    return std::nullopt;
  }
  const Eigen::VectorXd step = cholesky.solve(gradient);
  const double decrement = gradient.dot(step);
  if (!std::isfinite(decrement)) {
    return std::nullopt;
  }
  return Step{subspace ? Eigen::VectorXd(*subspace * step) : step,
              std::sqrt(std::max(0.0, decrement))};
}

/// True if `now` is no worse than `before`, up to the rounding of sums of such size.
bool no_worse(double now, double before) {
  return now >= before - 1e-13 * (1.0 + std::abs(before));
}

}  // namespace

std::string_view to_string(Termination termination) noexcept {
  switch (termination) {
    case Termination::converged:
      return "converged";
    case Termination::diverging:
      return "diverging";
    case Termination::iteration_limit:
      return "iteration limit";
    case Termination::no_ascent:
      return "no ascent";
    case Termination::singular:
      return "singular information";
  }
  return "";
}

NewtonResult maximise_binomial(const Eigen::MatrixXd& design,
                               const BinomialRows& rows,
                               const Eigen::VectorXd& start,
                               const std::optional<Eigen::MatrixXd>& subspace,
                               const NewtonOptions& options,
                               const DivergenceTest& diverges) {
  NewtonResult result;
  result.coefficients = start;
  result.at = binomial_likelihood(design, rows, start);
  bool asked = !diverges;
  while (true) {
    if (!asked && result.at.largest_eta > kSuspiciousEta) {
      asked = true;
      if (diverges()) {
        result.termination = Termination::diverging;
        return result;
      }
    }
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
    BinomialLikelihood at = binomial_likelihood(design, rows, next);
    for (int halving = 0; !no_worse(at.log_likelihood, result.at.log_likelihood); ++halving) {
      if (halving == options.max_halvings) {
        result.termination = Termination::no_ascent;
        return result;
      }
      scale *= 0.5;
      next = result.coefficients + scale * step->direction;
      at = binomial_likelihood(design, rows, next);
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
