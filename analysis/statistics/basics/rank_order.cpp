#include <statistics/basics/rank_order.hpp>

#include <algorithm>

namespace tcert::statistics {

std::vector<std::uint32_t> rank_order(std::span<const double> score, HigherMeans higher) {
  // The score sorts beside its row: a comparison that looks it up waits for memory.
  struct Ranked {
    double score = 0.0;
    std::uint32_t row = 0;
  };
  const double sign = higher == HigherMeans::success ? 1.0 : -1.0;
  std::vector<Ranked> ranked(score.size());
  for (std::uint32_t row = 0; row < score.size(); ++row) {
    ranked[row] = {sign * score[row], row};
  }
  std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return a.score != b.score ? a.score < b.score : a.row < b.row;
  });
  std::vector<std::uint32_t> order(score.size());
  std::transform(
      ranked.begin(), ranked.end(), order.begin(), [](const Ranked& one) { return one.row; });
  return order;
}

}  // namespace tcert::statistics
