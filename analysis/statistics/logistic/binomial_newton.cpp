#include <statistics/logistic/binomial_newton.hpp>

#include <cmath>
#include <optional>
#include <statistics/basics/linalg.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

/// False if a pivot is nothing but rounding: a direction that no row with trials looks along.
bool invertible(const Cholesky& cholesky) {
  const Eigen::VectorXd pivots = cholesky.pivots().cwiseAbs2();
  return pivots.minCoeff() > 1e-14 * pivots.maxCoeff();
}

std::optional<NewtonStep> newton_step(const BinomialLikelihood& at,
                                      const std::optional<Eigen::MatrixXd>& subspace) {
  const Eigen::VectorXd gradient =
      subspace ? Eigen::VectorXd(subspace->transpose() * at.gradient) : at.gradient;
  const Eigen::MatrixXd information =
      subspace ? Eigen::MatrixXd(subspace->transpose() * at.information * *subspace)
               : at.information;
  if (gradient.size() == 0) {
    return NewtonStep{Eigen::VectorXd::Zero(at.gradient.size()), 0.0};
  }
  const Cholesky cholesky(information);
  if (!cholesky.succeeded() || !invertible(cholesky)) {
    return std::nullopt;
  }
  const Eigen::VectorXd step = cholesky.solve(gradient);
  const double decrement = gradient.dot(step);
  if (!std::isfinite(decrement)) {
    return std::nullopt;
  }
  return NewtonStep{subspace ? Eigen::VectorXd(*subspace * step) : step,
                    std::sqrt(std::max(0.0, decrement))};
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
  bool asked = !diverges;
  return newton_ascent(
      start,
      options,
      &BinomialLikelihood::log_likelihood,
      [&](const Eigen::VectorXd& at) { return binomial_likelihood(design, rows, at); },
      [&](const BinomialLikelihood& at) { return newton_step(at, subspace); },
      [&](const BinomialLikelihood& at) {
        if (asked || at.largest_eta <= kSuspiciousEta) {
          return false;
        }
        asked = true;
        return diverges();
      });
}

}  // namespace tcert::statistics
