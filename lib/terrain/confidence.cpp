#include <algorithm>
#include <cmath>
#include <terrain/confidence.hpp>

namespace tcert::terrain {
namespace {

constexpr double kSmallestVariance = 1e-15;

}  // namespace

void set_to_band(Intervals& intervals,
                 std::span<const double> mean,
                 std::span<const double> variance,
                 double k) {
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const double half = k * std::sqrt(std::max(variance[i], kSmallestVariance));
    intervals.lower[i] = mean[i] - half;
    intervals.upper[i] = mean[i] + half;
  }
}

std::size_t intersect_with_band(Intervals& intervals,
                                std::span<const double> mean,
                                std::span<const double> variance,
                                double k,
                                const CellSet* where) {
  std::size_t empty = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (where != nullptr && (*where)[i] == 0) {
      continue;
    }
    const double half = k * std::sqrt(std::max(variance[i], kSmallestVariance));
    intervals.lower[i] = std::max(intervals.lower[i], mean[i] - half);
    intervals.upper[i] = std::min(intervals.upper[i], mean[i] + half);
    empty += intervals.lower[i] > intervals.upper[i] ? 1U : 0U;
  }
  return empty;
}

void intersect_with_cone(Intervals& intervals,
                         const Grid& grid,
                         Cell c,
                         double y,
                         double noise_bound,
                         double lipschitz) {
  for (int x = 0; x < grid.rows; ++x) {
    const std::size_t row = grid.index({x, 0});
    const double dx = x - c.x;
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t i = row + static_cast<std::size_t>(column);
      const double dy = column - c.y;
      const double slack = noise_bound + lipschitz * std::sqrt(dx * dx + dy * dy);
      intervals.lower[i] = std::max(intervals.lower[i], y - slack);
      intervals.upper[i] = std::min(intervals.upper[i], y + slack);
    }
  }
}

}  // namespace tcert::terrain
