#include <algorithm>
#include <cmath>
#include <terrain/selection.hpp>

namespace tcert::terrain {
namespace {

constexpr double kEqualWidths = 1e-10;  // relative

/// The first `n` in the order of `before`, sorted by index.
template <class Before>
[[nodiscard]] std::vector<std::size_t> first_cells(std::vector<std::size_t> candidates,
                                                   std::size_t n,
                                                   Before before) {
  if (candidates.size() <= n) {
    return candidates;
  }
  std::nth_element(candidates.begin(),
                   candidates.begin() + static_cast<std::ptrdiff_t>(n),
                   candidates.end(),
                   before);
  candidates.resize(n);
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

}  // namespace

std::vector<std::size_t> nearest_cells(const Grid& grid,
                                       std::vector<std::size_t> candidates,
                                       Cell goal,
                                       std::size_t n) {
  return first_cells(std::move(candidates), n, [&](std::size_t a, std::size_t b) {
    const double da = squared_distance(grid.cell(a), goal);
    const double db = squared_distance(grid.cell(b), goal);
    return da != db ? da < db : a < b;
  });
}

std::vector<std::size_t> widest_cells(std::vector<std::size_t> candidates,
                                      const Intervals& intervals,
                                      std::size_t n) {
  return first_cells(std::move(candidates), n, [&](std::size_t a, std::size_t b) {
    const double wa = intervals.width(a);
    const double wb = intervals.width(b);
    return wa != wb ? wa > wb : a < b;
  });
}

std::optional<std::size_t> widest_cell(const Grid& grid,
                                       const std::vector<std::size_t>& candidates,
                                       const Intervals& intervals,
                                       std::optional<Cell> goal,
                                       Ties ties) {
  double widest = -kUnbounded;
  for (const std::size_t i : candidates) {
    widest = std::max(widest, intervals.width(i));
  }
  // Measurements in symmetric places make widths that differ by rounding alone.
  const double equal =
      std::isinf(widest) ? widest : widest - kEqualWidths * (1.0 + std::abs(widest));
  std::optional<std::size_t> best;
  for (const std::size_t i : candidates) {
    if (!(intervals.width(i) >= equal)) {
      continue;
    }
    const bool nearer =
        best && goal && ties == Ties::nearest_first &&
        squared_distance(grid.cell(i), *goal) < squared_distance(grid.cell(*best), *goal);
    if (!best || nearer) {
      best = i;
    }
  }
  return best;
}

std::vector<std::size_t> members(const CellSet& set) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set[i] != 0) {
      indices.push_back(i);
    }
  }
  return indices;
}

}  // namespace tcert::terrain
