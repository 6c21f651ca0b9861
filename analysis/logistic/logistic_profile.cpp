#include "analysis/logistic/logistic_profile.hpp"

#include "analysis/logistic/likelihood_profile.hpp"
#include "analysis/logistic/logistic_problem.hpp"

namespace tcert {
namespace {

LikelihoodPoint point_of(const NewtonResult& newton) {
  return {newton.coefficients, newton.at.log_likelihood, newton.at.gradient, newton.at.information};
}

}  // namespace

std::vector<std::optional<Interval>> profile_intervals(const LogisticInput& input,
                                                       const LogisticOptions& options) {
  std::vector<std::optional<Interval>> intervals(input.columns.size());
  const LogisticFit fit = fit_logistic(input, options);
  if (has_error(fit.conditions) || fit.separation != Separation::none) {
    return intervals;
  }
  const LogisticProblem problem = logistic_problem(input);
  const NewtonResult newton = maximum_of(input, problem, options.newton).newton;
  const ConstrainedMaximum maximise = [&](const Eigen::VectorXd& start,
                                          const Eigen::MatrixXd& subspace) {
    const NewtonResult result =
        maximise_binomial(problem.space.basis, problem.rows, start, subspace, options.newton);
    return result.converged() ? std::optional(point_of(result)) : std::nullopt;
  };
  const Eigen::MatrixXd back = inverse_triangle(problem.space);
  for (std::size_t k = 0; k < problem.space.kept.size(); ++k) {
    const Eigen::VectorXd functional = back.row(static_cast<Eigen::Index>(k)).transpose();
    intervals[problem.space.kept[k]] =
        profile_interval(point_of(newton), functional, maximise, options.level);
  }
  return intervals;
}

}  // namespace tcert
