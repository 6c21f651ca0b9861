#include <statistics/glmm/glmm_maximum.hpp>

#include <cmath>
#include <statistics/basics/linalg.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

constexpr double kLargestTheta = 1000.0;
constexpr int kMaxHalvings = 40;

struct Step {
  Eigen::VectorXd direction;
  double length = 0.0;  ///< In standard errors.
  bool concave = true;  ///< The Hessian is negative definite.
  bool uphill = true;   ///< The gradient says where to; else the direction leaves a saddle.
};

/// Where the Hessian is not negative definite: as if its curvatures had the right sign, or if the
/// gradient is 0, along the direction that curves up most.
Step step_over_saddle(const Eigen::VectorXd& gradient, const Eigen::MatrixXd& information) {
  const Eigensystem system = eigensystem_of(information);
  const Eigen::VectorXd& curvature = system.values;
  const double largest = std::max(curvature.cwiseAbs().maxCoeff(), 1e-300);
  const Eigen::VectorXd size = curvature.cwiseAbs().cwiseMax(1e-6 * largest);
  const Eigen::VectorXd along = system.vectors.transpose() * gradient;
  const Eigen::VectorXd move = along.cwiseQuotient(size);
  Step step;
  step.concave = curvature[0] > -1e-10 * largest;
  step.length = std::sqrt(along.dot(move));
  step.direction = system.vectors * move;
  if (!step.concave && step.length < 1e-3) {
    step.uphill = false;
    step.direction = system.vectors.col(0) / std::sqrt(size[0]);
  }
  return step;
}

Step step_at(const LikelihoodPoint& at, const std::optional<Eigen::MatrixXd>& subspace) {
  const Eigen::VectorXd gradient =
      subspace ? Eigen::VectorXd(subspace->transpose() * at.gradient) : at.gradient;
  const Eigen::MatrixXd information =
      subspace ? Eigen::MatrixXd(-(subspace->transpose() * at.hessian * *subspace))
               : Eigen::MatrixXd(-at.hessian);
  Step step;
  if (gradient.size() == 0) {
    step.direction = Eigen::VectorXd::Zero(at.gradient.size());
    return step;
  }
  const Cholesky cholesky(information);
  if (cholesky.succeeded()) {
    step.direction = cholesky.solve(gradient);
    step.length = std::sqrt(std::max(0.0, gradient.dot(step.direction)));
  } else {
    step = step_over_saddle(gradient, information);
  }
  if (subspace) {
    step.direction = *subspace * step.direction;
  }
  return step;
}

/// True if `now` is no worse than `before`, up to the rounding of sums of such size.
bool no_worse(double now, double before) {
  return now >= before - 1e-13 * (1.0 + std::abs(before));
}

/// Takes the step, halved until the likelihood does not fall; false if it always does.
bool take(MixedLikelihood& likelihood, const Step& step, GlmmMaximum& maximum) {
  double scale = 1.0;
  for (int halving = 0; halving <= kMaxHalvings; ++halving) {
    const Eigen::VectorXd next = maximum.parameters + scale * step.direction;
    LikelihoodPoint at;
    ++maximum.evaluations;
    if (likelihood.evaluate(next, Derivatives::hessian, at) &&
        no_worse(at.value, maximum.at.value)) {
      maximum.parameters = next;
      maximum.at = std::move(at);
      ++maximum.iterations;
      return true;
    }
    scale *= 0.5;
  }
  return false;
}

}  // namespace

std::string_view to_string(GlmmTermination termination) noexcept {
  switch (termination) {
    case GlmmTermination::converged:
      return "converged";
    case GlmmTermination::not_started:
      return "not started";
    case GlmmTermination::iteration_limit:
      return "iteration limit";
    case GlmmTermination::no_ascent:
      return "no ascent";
    case GlmmTermination::diverging:
      return "diverging";
  }
  return "";
}

bool is_concave(const Eigen::MatrixXd& hessian) {
  const Eigen::VectorXd curvature = eigenvalues_of(hessian);
  return curvature.maxCoeff() <= 1e-10 * curvature.cwiseAbs().maxCoeff();
}

GlmmMaximum newton_maximum(MixedLikelihood& likelihood,
                           const Eigen::VectorXd& start,
                           const std::optional<Eigen::MatrixXd>& subspace,
                           const GlmmOptions& options) {
  GlmmMaximum maximum;
  maximum.parameters = start;
  ++maximum.evaluations;
  if (!likelihood.evaluate(start, Derivatives::hessian, maximum.at)) {
    maximum.termination = GlmmTermination::no_ascent;
    return maximum;
  }
  while (true) {
    const Step step = step_at(maximum.at, subspace);
    maximum.last_step = step.length;
    if (maximum.parameters.head(likelihood.thetas()).cwiseAbs().maxCoeff() > kLargestTheta) {
      maximum.termination = GlmmTermination::diverging;
      return maximum;
    }
    const bool last = step.concave && step.length <= options.step_tolerance;
    if (!last && maximum.iterations == options.max_iterations) {
      maximum.termination = GlmmTermination::iteration_limit;
      return maximum;
    }
    if (!take(likelihood, step, maximum)) {
      // At a gradient of rounding a step that is short enough has arrived.
      maximum.termination = last ? GlmmTermination::converged : GlmmTermination::no_ascent;
      return maximum;
    }
    if (last) {
      return maximum;
    }
  }
}

Eigen::MatrixXd free_directions(const std::vector<bool>& fixed) {
  const auto size = static_cast<Eigen::Index>(fixed.size());
  std::vector<Eigen::Index> kept;
  for (Eigen::Index j = 0; j < size; ++j) {
    if (!fixed[static_cast<std::size_t>(j)]) {
      kept.push_back(j);
    }
  }
  return Eigen::MatrixXd::Identity(size, size)(Eigen::all, kept);
}

}  // namespace tcert::statistics
