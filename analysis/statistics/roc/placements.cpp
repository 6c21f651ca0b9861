#include <statistics/roc/placements.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <statistics/basics/rank_order.hpp>
#include <stdexcept>

namespace tcert::statistics {

Placements placements(std::span<const double> score,
                      std::span<const std::uint8_t> success,
                      HigherMeans higher) {
  assert(score.size() == success.size());
  if (std::any_of(score.begin(), score.end(), [](double x) { return std::isnan(x); })) {
    throw std::invalid_argument("placements: a score is NaN");
  }
  const std::size_t n = score.size();
  const std::vector<std::uint32_t> order = rank_order(score, higher);
  const auto is_success = [&](std::size_t row) { return success[row] != 0; };
  const auto successes = static_cast<std::size_t>(
      std::count_if(success.begin(), success.end(), [](std::uint8_t s) { return s != 0; }));
  const std::size_t failures = n - successes;
  assert(successes > 0 && failures > 0);

  // Twice the number of pairs, so that a tie is a whole number and the sum is exact.
  std::vector<double> twice_outranked(n);
  double twice_wins = 0.0;
  std::size_t failures_below = 0;
  std::size_t successes_below = 0;
  Placements result;
  for (std::size_t first = 0; first < n;) {
    std::size_t last = first;
    std::size_t tied_successes = 0;
    while (last < n && score[order[last]] == score[order[first]]) {
      if (is_success(order[last++])) {
        ++tied_successes;
      }
    }
    const std::size_t tied_failures = last - first - tied_successes;
    for (std::size_t k = first; k < last; ++k) {
      twice_outranked[order[k]] = static_cast<double>(
          is_success(order[k]) ? 2 * failures_below + tied_failures
                               : 2 * (successes - successes_below) - tied_successes);
      if (is_success(order[k])) {
        twice_wins += twice_outranked[order[k]];
      }
    }
    failures_below += tied_failures;
    successes_below += tied_successes;
    first = last;
    ++result.distinct;
  }

  result.successes.reserve(successes);
  result.failures.reserve(failures);
  for (std::size_t row = 0; row < n; ++row) {
    if (is_success(row)) {
      result.successes.push_back(twice_outranked[row] / (2.0 * static_cast<double>(failures)));
    } else {
      result.failures.push_back(twice_outranked[row] / (2.0 * static_cast<double>(successes)));
    }
  }
  result.auc = twice_wins / (2.0 * static_cast<double>(successes) * static_cast<double>(failures));
  return result;
}

}  // namespace tcert::statistics
