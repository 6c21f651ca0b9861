#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <cmath>
#include <statistics/basics/linalg.hpp>
#include <statistics/glmm/glmm_maximum.hpp>

namespace tcert::statistics {
namespace {

/// Minus the log-likelihood at origin + metric * x, divided by `size`.
class Deviance final : public ceres::FirstOrderFunction {
 public:
  Deviance(MixedLikelihood& likelihood,
           Eigen::VectorXd origin,
           Eigen::MatrixXd metric,
           double size,
           int& evaluations)
      : likelihood_(likelihood),
        origin_(std::move(origin)),
        metric_(std::move(metric)),
        size_(size),
        evaluations_(evaluations) {}

  bool Evaluate(const double* x, double* cost, double* gradient) const override {
    const Eigen::Map<const Eigen::VectorXd> at(x, metric_.cols());
    LikelihoodPoint point;
    ++evaluations_;
    const bool possible =
        likelihood_.evaluate(origin_ + metric_ * at,
                             gradient == nullptr ? Derivatives::none : Derivatives::gradient,
                             point);
    if (!possible || !std::isfinite(point.value)) {
      return false;
    }
    *cost = -point.value / size_;
    if (gradient != nullptr) {
      Eigen::Map<Eigen::VectorXd>(gradient, metric_.cols()) =
          metric_.transpose() * point.gradient / -size_;
    }
    return true;
  }
  [[nodiscard]] int NumParameters() const override { return static_cast<int>(metric_.cols()); }

 private:
  MixedLikelihood& likelihood_;
  Eigen::VectorXd origin_;
  Eigen::MatrixXd metric_;
  double size_;
  int& evaluations_;
};

/// Directions along which a step of 1 is about one standard error, as far as the curvature at one
/// point can tell.
Eigen::MatrixXd metric_of(const Eigen::MatrixXd& hessian) {
  // Deviations between groups and coefficients may differ by orders of magnitude in curvature.
  const Eigen::VectorXd unit = hessian.diagonal().unaryExpr(
      [](double value) { return value != 0.0 ? 1.0 / std::sqrt(std::abs(value)) : 1.0; });
  const Eigensystem system = eigensystem_of(unit.asDiagonal() * hessian * unit.asDiagonal());
  const Eigen::VectorXd scale = system.values.unaryExpr(
      [](double value) { return 1.0 / std::sqrt(std::max(std::abs(value), 1e-3)); });
  return unit.asDiagonal() * system.vectors * scale.asDiagonal();
}

}  // namespace

Eigen::VectorXd search_maximum(MixedLikelihood& likelihood,
                               const Eigen::VectorXd& start,
                               double gradient_tolerance,
                               double relative_tolerance,
                               int& iterations,
                               int& evaluations) {
  LikelihoodPoint point;
  ++evaluations;
  if (!likelihood.evaluate(start, Derivatives::hessian, point) || !point.hessian.allFinite() ||
      !point.gradient.allFinite()) {
    return start;
  }
  Eigen::MatrixXd metric = metric_of(point.hessian);
  // Ceres begins with a step as long as the gradient, but no longer than 1: in these units that is
  // the Newton step.
  const double unit = std::max(1e-8, (metric.transpose() * point.gradient).cwiseAbs().maxCoeff());
  metric *= unit;
  const ceres::GradientProblem problem(
      new Deviance(likelihood, start, metric, unit * unit, evaluations));
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = ceres::BFGS;
  options.line_search_type = ceres::WOLFE;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 100;
  // Near enough for Newton's method is a matter of how far it has come, not of standard errors.
  options.gradient_tolerance = std::max(gradient_tolerance / unit, relative_tolerance);
  options.function_tolerance = 1e-12;
  ceres::GradientProblemSolver::Summary summary;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(start.size());
  ceres::Solve(options, problem, x.data(), &summary);
  iterations += static_cast<int>(summary.iterations.size());
  return x.allFinite() ? Eigen::VectorXd(start + metric * x) : start;
}

}  // namespace tcert::statistics
