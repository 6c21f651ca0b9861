#include <statistics/logistic/firth_newton.hpp>

#include <cmath>
#include <statistics/basics/linalg.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

std::optional<NewtonStep> step_by(const Eigen::MatrixXd& curvature,
                                  const Eigen::VectorXd& gradient) {
  const Cholesky cholesky(curvature);
  if (!cholesky.succeeded()) {
    return std::nullopt;
  }
  Eigen::VectorXd direction = cholesky.solve(gradient);
  const double decrement = gradient.dot(direction);
  if (!std::isfinite(decrement)) {
    return std::nullopt;
  }
  return NewtonStep{std::move(direction), std::sqrt(std::max(0.0, decrement))};
}

std::optional<NewtonStep> newton_step(const FirthLikelihood& at,
                                      const std::optional<Eigen::MatrixXd>& subspace) {
  if (!std::isfinite(at.value)) {
    return std::nullopt;
  }
  if (!subspace) {
    const auto exact = step_by(at.curvature, at.gradient);
    return exact ? exact : step_by(at.information, at.gradient);
  }
  if (subspace->cols() == 0) {
    return NewtonStep{Eigen::VectorXd::Zero(at.gradient.size()), 0.0};
  }
  const auto within = [&](const Eigen::MatrixXd& curvature) {
    return step_by(subspace->transpose() * curvature * *subspace,
                   subspace->transpose() * at.gradient);
  };
  std::optional<NewtonStep> step = within(at.curvature);
  if (!step) {
    step = within(at.information);
  }
  if (step) {
    step->direction = *subspace * step->direction;
  }
  return step;
}

}  // namespace

FirthNewtonResult maximise_firth(const Eigen::MatrixXd& design,
                                 const BinomialRows& rows,
                                 const Eigen::VectorXd& start,
                                 const std::optional<Eigen::MatrixXd>& subspace,
                                 const NewtonOptions& options) {
  return newton_ascent(
      start,
      options,
      &FirthLikelihood::value,
      [&](const Eigen::VectorXd& at) { return firth_likelihood(design, rows, at); },
      [&](const FirthLikelihood& at) { return newton_step(at, subspace); },
      [](const FirthLikelihood&) { return false; });
}

}  // namespace tcert::statistics
