#include <algorithm>
#include <limits>
#include <numeric>

#include "analysis/complete_rows.hpp"
#include "analysis/roc.hpp"

namespace tcert {

std::vector<RocPoint> roc_points(std::span<const double> score,
                                 std::span<const double> success,
                                 HigherMeans higher) {
  const CompleteRows rows = complete_rows({score}, success);
  if (rows.successes == 0 || rows.failures == 0) {
    return {};
  }
  const std::vector<double>& x = rows.scores[0];
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const bool rising = higher == HigherMeans::success;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rising ? x[a] < x[b] : x[b] < x[a];
  });

  const double infinity = std::numeric_limits<double>::infinity();
  const auto successes = static_cast<double>(rows.successes);
  const auto failures = static_cast<double>(rows.failures);
  std::vector<RocPoint> points{{rising ? -infinity : infinity, 1.0, 0.0}};
  std::size_t successes_below = 0;
  std::size_t failures_below = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    ++(rows.success[order[k]] != 0 ? successes_below : failures_below);
    const bool last = k + 1 == order.size();
    if (!last && x[order[k]] == x[order[k + 1]]) {
      continue;
    }
    const double threshold =
        last ? (rising ? infinity : -infinity) : std::midpoint(x[order[k]], x[order[k + 1]]);
    points.push_back({threshold,
                      static_cast<double>(rows.successes - successes_below) / successes,
                      static_cast<double>(failures_below) / failures});
  }
  return points;
}

}  // namespace tcert
