#include <statistics/cox/cox_runaway.hpp>

#include <cmath>
#include <statistics/basics/linalg.hpp>
#include <statistics/basics/runaway.hpp>

namespace tcert::statistics {

std::vector<bool> cox_runaways(const CoxData& data,
                               const CoxRows& rows,
                               const CoxMaximum& maximum,
                               const Eigen::MatrixXd& inverse,
                               std::size_t events) {
  std::vector<bool> away(data.columns.size(), false);
  const std::vector<Eigen::Index> ranked = ranked_columns(maximum.columns);
  if (ranked.empty()) {
    return away;
  }
  // Next to no column needs its spread.
  std::vector<std::size_t> candidates;
  for (std::size_t k = 0; k < ranked.size(); ++k) {
    const Eigen::Index j = ranked[k];
    const auto column = data.design.col(j);
    const double range = (column.maxCoeff() - column.minCoeff()) / rows.scale(j);
    if (may_have_run_away({maximum.beta(j) * range, std::sqrt(inverse(j, j)) * range})) {
      candidates.push_back(k);
    }
  }
  if (candidates.empty()) {
    return away;
  }
  const Eigen::MatrixXd null = maximum.null.information(ranked, ranked);
  const Eigen::MatrixXd without_effect = inverse_symmetric(null);
  for (const std::size_t k : candidates) {
    const Eigen::Index j = ranked[k];
    const double variance = inverse(j, j);
    if (std::isnan(variance)) {
      continue;
    }
    const auto column = data.design.col(j);
    const double spread =
        typical_spread(std::vector<double>(column.begin(), column.end())) / rows.scale(j);
    const auto at = static_cast<Eigen::Index>(k);
    away[static_cast<std::size_t>(j)] = has_run_away({maximum.beta(j) * spread,
                                                      std::sqrt(variance) * spread,
                                                      std::sqrt(without_effect(at, at)) * spread},
                                                     static_cast<double>(events));
  }
  return away;
}

}  // namespace tcert::statistics
