#include <cmath>
#include <numeric>
#include <statistics/basics/linalg.hpp>
#include <statistics/glmm/glmm_parts.hpp>
#include <statistics/logistic/logistic_estimates.hpp>
#include <statistics/logistic/near_separation.hpp>

namespace tcert::statistics {
namespace {

/// The inverse of a positive semidefinite matrix; directions without curvature count as known.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& information) {
  const Cholesky cholesky(information);
  if (cholesky.succeeded()) {
    return cholesky.inverse();
  }
  const Eigensystem system = eigensystem_of(information);
  const double least = 1e-10 * system.values.maxCoeff();
  const Eigen::VectorXd inverse =
      system.values.unaryExpr([least](double value) { return value > least ? 1.0 / value : 0.0; });
  return system.vectors * inverse.asDiagonal() * system.vectors.transpose();
}

/// Per kept coefficient: see `ran_away()`, at the fixed part's linear predictors.
std::vector<bool> runaways(const GlmmInput& input,
                           const GlmmProblem& problem,
                           const GlmmMaximum& maximum,
                           const Eigen::MatrixXd& back,
                           const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd along = maximum.parameters.tail(back.cols());
  Eigen::VectorXd eta = problem.fixed.space.basis * along;
  if (problem.fixed.rows.offset.size() > 0) {
    eta += problem.fixed.rows.offset;
  }
  std::vector<std::size_t> names(input.fixed.columns.size());
  std::iota(names.begin(), names.end(), 0U);
  const Eigen::VectorXd estimates = back * along;
  const Eigen::VectorXd variances = covariance.diagonal();
  const Eigen::VectorXd units = Eigen::VectorXd::Ones(back.rows());
  return ran_away(input.fixed,
                  problem.fixed,
                  names,
                  {back, estimates, variances, units},
                  eta.size() > 0 ? eta.cwiseAbs().maxCoeff() : 0.0);
}

}  // namespace

void add_fixed_effects(const GlmmInput& input,
                       const GlmmProblem& problem,
                       const GlmmMaximum& maximum,
                       GlmmFit& fit) {
  const Eigen::Index rank = problem.fixed.space.rank();
  const Eigen::MatrixXd back = inverse_triangle(problem.fixed.space);
  const Eigen::VectorXd estimates = back * maximum.parameters.tail(rank);
  const Eigen::MatrixXd joint = inverse_of(-maximum.at.hessian);
  const Eigen::MatrixXd covariance = back * joint.bottomRightCorner(rank, rank) * back.transpose();
  const std::vector<std::size_t>& kept = problem.fixed.space.kept;
  const std::vector<bool> away = runaways(input, problem, maximum, back, covariance);
  for (std::size_t a = 0; a < kept.size(); ++a) {
    const auto row = static_cast<Eigen::Index>(a);
    if (away[a]) {
      withhold_estimate(estimates[row],
                        std::sqrt(covariance(row, row)),
                        fit.coefficients[kept[a]],
                        fit.conditions);
      continue;
    }
    set_estimate(
        fit.coefficients[kept[a]], estimates[row], covariance(row, row), 1.0, fit.options.level);
    for (std::size_t b = 0; b < kept.size(); ++b) {
      if (!away[b]) {
        fit.covariance(static_cast<Eigen::Index>(kept[a]), static_cast<Eigen::Index>(kept[b])) =
            covariance(row, static_cast<Eigen::Index>(b));
      }
    }
  }
}

}  // namespace tcert::statistics
