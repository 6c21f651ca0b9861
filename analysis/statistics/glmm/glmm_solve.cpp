#include <statistics/glmm/glmm_solve.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tcert::statistics {
namespace {

/// A standard deviation below this is set to 0 if the likelihood does not fall by it.
constexpr double kSmallTheta = 1e-3;
constexpr double kStartTheta = 0.7;

Eigen::VectorXd start_of(const GlmmProblem& problem, double theta) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(problem.size());
  for (const Eigen::Index place : diagonal_places(problem)) {
    start[place] = theta;
  }
  start.tail(problem.plain.coefficients.size()) = problem.plain.coefficients;
  return start;
}

void take_better(GlmmMaximum&& other, GlmmMaximum& maximum) {
  const int iterations = maximum.iterations + other.iterations;
  const int evaluations = maximum.evaluations + other.evaluations;
  const double tolerance = 1e-12 * (1.0 + std::abs(maximum.at.value));
  if (other.converged() &&
      (!maximum.converged() || other.at.value >= maximum.at.value - tolerance)) {
    maximum = std::move(other);
  }
  maximum.iterations = iterations;
  maximum.evaluations = evaluations;
}

/// The likelihood is even in each column of a factor, so that 0 is a stationary value of a diagonal
/// that stands alone: where the optimum lies there it is reached by setting it.
void settle_on_boundary(const GlmmProblem& problem,
                        MixedLikelihood& likelihood,
                        const GlmmOptions& options,
                        GlmmMaximum& maximum) {
  Eigen::VectorXd settled = maximum.parameters;
  std::vector<bool> fixed(static_cast<std::size_t>(settled.size()), false);
  for (const Eigen::Index place : diagonal_places(problem)) {
    if (std::abs(settled[place]) < kSmallTheta) {
      settled[place] = 0.0;
      fixed[static_cast<std::size_t>(place)] = true;
    }
  }
  const bool any = std::find(fixed.begin(), fixed.end(), true) != fixed.end();
  if (!maximum.converged() || !any) {
    return;
  }
  GlmmMaximum at = newton_maximum(likelihood, settled, free_directions(fixed), options);
  if (at.converged() && is_concave(at.at.hessian)) {
    take_better(std::move(at), maximum);
  }
}

/// Never worse than without random effects.
void compare_with_plain(const GlmmProblem& problem,
                        MixedLikelihood& likelihood,
                        const GlmmOptions& options,
                        GlmmMaximum& maximum) {
  const double plain = problem.plain.at.log_likelihood;
  if (!maximum.converged() || maximum.at.value < plain - 1e-12 * (1.0 + std::abs(plain))) {
    take_better(newton_maximum(likelihood, start_of(problem, 0.0), std::nullopt, options), maximum);
  }
}

void make_diagonals_positive(const GlmmProblem& problem, GlmmMaximum& maximum) {
  Eigen::VectorXd sign = Eigen::VectorXd::Ones(problem.size());
  Eigen::Index at = 0;
  for (const TermRows& term : problem.terms) {
    for (auto left = static_cast<Eigen::Index>(term.columns.size()); left > 0; --left) {
      if (maximum.parameters[at] < 0.0) {
        sign.segment(at, left).setConstant(-1.0);
      }
      at += left;
    }
  }
  maximum.parameters = sign.cwiseProduct(maximum.parameters);
  maximum.at.gradient = sign.cwiseProduct(maximum.at.gradient);
  maximum.at.hessian = sign.asDiagonal() * maximum.at.hessian * sign.asDiagonal();
}

}  // namespace

std::vector<Eigen::Index> diagonal_places(const GlmmProblem& problem) {
  std::vector<Eigen::Index> places;
  Eigen::Index at = 0;
  for (const TermRows& term : problem.terms) {
    for (auto left = static_cast<Eigen::Index>(term.columns.size()); left > 0; --left) {
      places.push_back(at);
      at += left;
    }
  }
  return places;
}

GlmmMaximum solve(const GlmmProblem& problem, int quadrature, const GlmmOptions& options) {
  int iterations = 0;
  int evaluations = 0;
  const std::unique_ptr<MixedLikelihood> laplace = problem.likelihood(1);
  const bool newton_is_cheap = laplace->has_cheap_hessian();
  const Eigen::VectorXd near = search_maximum(*laplace,
                                              start_of(problem, kStartTheta),
                                              newton_is_cheap ? 0.05 : 1e-4,
                                              newton_is_cheap ? 0.03 : 0.0,
                                              iterations,
                                              evaluations);
  const std::unique_ptr<MixedLikelihood> likelihood = problem.likelihood(quadrature);
  GlmmMaximum maximum = newton_maximum(*likelihood, near, std::nullopt, options);
  compare_with_plain(problem, *likelihood, options, maximum);
  settle_on_boundary(problem, *likelihood, options, maximum);
  maximum.iterations += iterations;
  maximum.evaluations += evaluations;
  if (maximum.at.hessian.size() > 0) {
    make_diagonals_positive(problem, maximum);
  }
  return maximum;
}

}  // namespace tcert::statistics
