#include <statistics/logistic/logistic_estimates.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <statistics/basics/linalg.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/logistic/near_separation.hpp>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

/// Sum over clusters of the outer products of their scores, along the basis.
Eigen::MatrixXd score_products(const LogisticInput& input,
                               const LogisticProblem& problem,
                               const Eigen::VectorXd& coefficients,
                               std::size_t& clusters) {
  const Eigen::MatrixXd& basis = problem.space.basis;
  Eigen::VectorXd eta = basis * coefficients;
  if (problem.rows.offset.size() > 0) {
    eta += problem.rows.offset;
  }
  const auto groups =
      input.cluster ? static_cast<Eigen::Index>(input.cluster->levels.size()) : problem.size();
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(basis.cols(), groups);
  std::vector<bool> seen(static_cast<std::size_t>(groups), false);
  for (Eigen::Index i = 0; i < basis.rows(); ++i) {
    const auto row = static_cast<std::size_t>(problem.used[static_cast<std::size_t>(i)]);
    const Eigen::Index group =
        input.cluster ? static_cast<Eigen::Index>(input.cluster->codes[row]) : i;
    const double residual =
        problem.rows.successes[i] - problem.rows.trials[i] * inverse_logit(eta[i]);
    scores.col(group) += residual * basis.row(i).transpose();
    seen[static_cast<std::size_t>(group)] = true;
  }
  clusters = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
  return scores * scores.transpose();
}

/// Covariance of the coefficients along the basis.
Eigen::MatrixXd basis_covariance(const LogisticInput& input,
                                 const LogisticProblem& problem,
                                 const NewtonResult& newton,
                                 LogisticFit& fit) {
  const Eigen::Index rank = problem.space.rank();
  Eigen::MatrixXd inverse = Cholesky(newton.at.information).inverse();
  if (fit.variance == CoefficientVariance::model) {
    return inverse;
  }
  const Eigen::MatrixXd products =
      score_products(input, problem, newton.coefficients, fit.clusters);
  if (fit.clusters < 2) {
    return Eigen::MatrixXd::Constant(rank, rank, table::kNaN);
  }
  return inverse * products * inverse;
}

/// Per kept column of the limit's problem: no dropped one can take its place.
std::vector<bool> determined(const LogisticProblem& problem) {
  const OrthonormalBasis& space = problem.space;
  std::vector<bool> result(space.kept.size(), true);
  for (Eigen::Index k = 0; k < space.combination.rows(); ++k) {
    for (Eigen::Index d = 0; d < space.combination.cols(); ++d) {
      // On the scale of the column's own norm along the basis, so that units do not matter.
      const double share = space.combination(k, d) * space.triangle.col(k).norm();
      const double whole =
          (space.triangle.triangularView<Eigen::Upper>() * space.combination.col(d)).norm();
      if (std::abs(share) > 1e-8 * whole) {
        result[static_cast<std::size_t>(k)] = false;
      }
    }
  }
  return result;
}

struct ScaledEstimates {
  const Eigen::MatrixXd& back;
  const Eigen::VectorXd& estimates;
  const Eigen::VectorXd& units;
};

/// Names the `known` coefficients that have run away, which are known no longer.
void withhold_runaways(const LogisticInput& input,
                       const LogisticProblem& problem,
                       const NewtonResult& newton,
                       const std::vector<std::size_t>& names,
                       const ScaledEstimates& scaled,
                       std::vector<bool>& known,
                       LogisticFit& fit) {
  if (!(newton.at.largest_eta > kSuspiciousEta)) {
    return;
  }
  const Cholesky information(newton.at.information);
  Eigen::VectorXd variances(scaled.back.rows());
  for (Eigen::Index k = 0; k < variances.size(); ++k) {
    const Eigen::VectorXd functional = scaled.back.row(k).transpose();
    variances[k] = functional.dot(information.solve(functional));
  }
  const std::vector<bool> away = ran_away(input,
                                          problem,
                                          names,
                                          {scaled.back, scaled.estimates, variances, scaled.units},
                                          newton.at.largest_eta);
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (!known[k] || !away[k]) {
      continue;
    }
    known[k] = false;
    const auto row = static_cast<Eigen::Index>(k);
    withhold_estimate(scaled.estimates[row] * scaled.units[row],
                      std::sqrt(variances[row]) * scaled.units[row],
                      fit.coefficients[names[problem.space.kept[k]]],
                      fit.conditions);
  }
}

}  // namespace

void set_estimate(
    LogisticCoefficient& coefficient, double scaled, double variance, double unit, double level) {
  const double estimate = scaled * unit;
  coefficient.kind = CoefficientKind::finite;
  coefficient.estimate = estimate;
  if (!(variance > 0.0)) {
    return;
  }
  const double error = std::sqrt(variance) * unit;
  const double half = normal_factor(level) * error;
  coefficient.standard_error = error;
  coefficient.z = scaled / std::sqrt(variance);
  coefficient.p_value = normal_p_value(*coefficient.z, Alternative::two_sided);
  coefficient.interval = Interval{estimate - half, estimate + half, level};
}

void withhold_estimate(double estimate,
                       double standard_error,
                       LogisticCoefficient& coefficient,
                       Conditions& conditions) {
  coefficient.kind = CoefficientKind::ran_away;
  conditions.push_back({ConditionKind::near_separation,
                        ConditionSeverity::warning,
                        coefficient.column,
                        fmt::format("a log odds ratio of {:.3g} with a standard error of {:.3g}",
                                    estimate,
                                    standard_error)});
}

void add_estimates(const LogisticInput& input,
                   const LogisticProblem& problem,
                   const NewtonResult& newton,
                   const std::vector<std::size_t>& names,
                   LogisticFit& fit) {
  Eigen::MatrixXd back = inverse_triangle(problem.space);
  Eigen::VectorXd units = Eigen::VectorXd::Ones(back.rows());
  if (back.cols() > 0) {
    units = back.cwiseAbs().rowwise().maxCoeff();
  }
  back = units.cwiseInverse().asDiagonal() * back;
  const Eigen::VectorXd estimates = back * newton.coefficients;
  const Eigen::MatrixXd covariance =
      back * basis_covariance(input, problem, newton, fit) * back.transpose();
  std::vector<bool> known = fit.separation == Separation::none
                                ? std::vector<bool>(problem.space.kept.size(), true)
                                : determined(problem);
  withhold_runaways(input, problem, newton, names, {back, estimates, units}, known, fit);
  for (std::size_t a = 0; a < known.size(); ++a) {
    if (!known[a]) {
      continue;
    }
    const std::size_t column = names[problem.space.kept[a]];
    const auto row = static_cast<Eigen::Index>(a);
    set_estimate(fit.coefficients[column],
                 estimates[row],
                 covariance(row, row),
                 units[row],
                 fit.options.level);
    for (std::size_t b = 0; b < known.size(); ++b) {
      if (known[b]) {
        fit.covariance(static_cast<Eigen::Index>(column),
                       static_cast<Eigen::Index>(names[problem.space.kept[b]])) =
            covariance(row, static_cast<Eigen::Index>(b)) * units[row] *
            units[static_cast<Eigen::Index>(b)];
      }
    }
  }
}

}  // namespace tcert::statistics
