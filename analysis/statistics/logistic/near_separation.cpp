#include <statistics/logistic/near_separation.hpp>

#include <cmath>
#include <statistics/basics/linalg.hpp>
#include <statistics/basics/runaway.hpp>

namespace tcert::statistics {

std::vector<bool> ran_away(const LogisticInput& input,
                           const LogisticProblem& problem,
                           const std::vector<std::size_t>& names,
                           const KeptEstimates& kept,
                           double largest_eta) {
  const auto size = static_cast<std::size_t>(kept.estimates.size());
  std::vector<bool> result(size, false);
  if (!(largest_eta > kSuspiciousEta) || size == 0) {
    return result;
  }
  const Eigen::MatrixXd& basis = problem.space.basis;
  const Cholesky even(basis.transpose() * (0.25 * problem.rows.trials).asDiagonal() * basis);
  const double trials = problem.rows.trials.sum();
  bool any = false;
  std::vector<std::size_t> without_spread;
  for (std::size_t k = 0; k < size; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const auto column = static_cast<Eigen::Index>(names[problem.space.kept[k]]);
    std::vector<double> values;
    values.reserve(problem.used.size());
    for (const Eigen::Index used : problem.used) {
      values.push_back(input.design(used, column));
    }
    const double spread = typical_spread(std::move(values)) * kept.units[row];
    if (spread == 0.0) {
      without_spread.push_back(k);
      continue;
    }
    const Eigen::VectorXd functional = kept.back.row(row).transpose();
    result[k] = has_run_away({kept.estimates[row] * spread,
                              std::sqrt(kept.variances[row]) * spread,
                              std::sqrt(functional.dot(even.solve(functional))) * spread},
                             trials);
    any = any || result[k];
  }
  for (const std::size_t k : without_spread) {
    const auto row = static_cast<Eigen::Index>(k);
    const double unit = kept.units[row];
    result[k] =
        any &&
        has_run_away({kept.estimates[row] * unit, std::sqrt(kept.variances[row]) * unit}, trials);
  }
  return result;
}

}  // namespace tcert::statistics
