#include <algorithm>
#include <queue>
#include <utility>

#include "analysis/cox/cox_newton.hpp"

namespace tcert {

bool is_monotone(const CoxRows& rows, const Eigen::VectorXd& direction) {
  const RiskSets& sets = rows.sets;
  std::vector<double> along(rows.rows());
  for (std::size_t place = 0; place < along.size(); ++place) {
    along[place] =
        Eigen::Map<const Eigen::VectorXd>(rows.row(place), direction.size()).dot(direction);
  }
  if (along.empty()) {
    return false;
  }
  const auto [low, high] = std::minmax_element(along.begin(), along.end());
  const double tolerance = 1e-3 * (*high - *low);
  if (!(tolerance > 0.0)) {
    return false;
  }
  for (std::size_t s = 0; s < sets.strata(); ++s) {
    // The largest at risk; a row that has left is dropped when it comes to the top.
    std::priority_queue<std::pair<double, std::uint32_t>> at_risk;
    for (std::size_t t = sets.stratum_begin[s + 1]; t-- > sets.stratum_begin[s];) {
      for (std::size_t place = sets.begin[t]; place < sets.begin[t + 1]; ++place) {
        at_risk.emplace(along[place], sets.first[sets.order[place]]);
      }
      while (at_risk.top().second > t) {
        at_risk.pop();
      }
      for (std::size_t place = sets.events_begin[t]; place < sets.begin[t + 1]; ++place) {
        if (along[place] < at_risk.top().first - tolerance) {
          return false;
        }
      }
    }
  }
  return true;
}

}  // namespace tcert
