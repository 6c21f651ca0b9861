#include <algorithm>
#include <cmath>
#include <terrain/pursuit.hpp>
#include <terrain/routes.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] bool is_ground(const Grid& grid, const CellSet& ground, const Position& p) {
  const Cell c = nearest_cell(p);
  return grid.contains(c) && ground[grid.index(c)] != 0;
}

/// Where a segment crosses a line that parts cells, as shares of it, ends included; ascending.
/// Between two of them all points round to one cell: that of the middle.
[[nodiscard]] std::vector<double> crossings_of(const Position& a, const Position& b) {
  const Eigen::Vector2d way = b - a;
  std::vector<double> crossings{0.0, 1.0};
  for (int axis = 0; axis < 2; ++axis) {
    const double low = std::min(a[axis], b[axis]);
    const double high = std::max(a[axis], b[axis]);
    double line = std::ceil(low - 0.5) + 0.5;
    while (line < high) {
      crossings.push_back(std::clamp((line - a[axis]) / way[axis], 0.0, 1.0));
      line += 1.0;
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

bool stays_on_ground(const Grid& grid,
                     const CellSet& ground,
                     const Position& a,
                     const Position& b) {
  const Eigen::Vector2d way = b - a;
  const std::vector<double> crossings = crossings_of(a, b);
  for (std::size_t k = 1; k < crossings.size(); ++k) {
    const Position middle = a + way * (0.5 * (crossings[k - 1] + crossings[k]));
    if (!is_ground(grid, ground, middle) || !is_ground(grid, ground, a + way * crossings[k])) {
      return false;
    }
  }
  return true;
}

std::vector<Cell> cells_along(const Position& a, const Position& b) {
  std::vector<Cell> cells;
  Cell before = nearest_cell(a);
  const std::vector<double> crossings = crossings_of(a, b);
  for (std::size_t k = 1; k < crossings.size(); ++k) {
    const Cell c = nearest_cell(a + (b - a) * (0.5 * (crossings[k - 1] + crossings[k])));
    if (!(c == before)) {
      cells.push_back(c);
      before = c;
    }
  }
  return cells;
}

std::vector<Position> pursuit_way(const Grid& grid,
                                  const CellSet& ground,
                                  const Position& from,
                                  Cell to) {
  const std::vector<Cell> route = shortest_route(grid, ground, nearest_cell(from), to);
  if (route.empty()) {
    return {};
  }
  std::vector<Position> way{from};
  std::size_t at = 0;  // of the route: what lies behind the robot
  while (way.back() != position(to)) {
    std::size_t next = route.size() - 1;
    while (next > at + 1 && !stays_on_ground(grid, ground, way.back(), position(route[next]))) {
      --next;
    }
    way.push_back(position(route[next]));
    at = next;
  }
  return way;
}

double length_of(const std::vector<Position>& way) noexcept {
  double length = 0.0;
  for (std::size_t k = 1; k < way.size(); ++k) {
    length += (way[k] - way[k - 1]).norm();
  }
  return length;
}

}  // namespace tcert::terrain
