#include <algorithm>
#include <terrain/components.hpp>
#include <terrain/confidence.hpp>
#include <terrain/distance_transform.hpp>
#include <terrain/projection.hpp>

namespace tcert::terrain {

std::optional<Cell> projected_inwards(const Grid& grid,
                                      const CellSet& safe,
                                      Cell target,
                                      double depth) {
  return nearest_deep(grid, fill_holes(grid, safe), target, depth);
}

std::optional<Cell> nearest_deep(const Grid& grid, const CellSet& set, Cell target, double depth) {
  const auto depth2 = squared_depth(grid, set);
  // The outline lies one cell within the nearest cell outside.
  const double needed = depth + 1.0;
  std::optional<Cell> nearest;
  double best = kUnbounded;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (set[i] == 0 || static_cast<double>(depth2[i]) < needed * needed) {
      continue;
    }
    const Cell c = grid.cell(i);
    const int edge = std::min({c.x, c.y, grid.rows - 1 - c.x, grid.columns - 1 - c.y});
    const double d2 = squared_distance(c, target);
    if (edge >= depth && d2 < best) {
      best = d2;
      nearest = c;
    }
  }
  return nearest;
}

}  // namespace tcert::terrain
