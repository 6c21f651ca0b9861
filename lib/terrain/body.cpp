#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <terrain/body.hpp>
#include <terrain/limits.hpp>
#include <terrain/row_counts.hpp>

namespace tcert::terrain {
namespace {

/// Half the side of the square of all places of a cell's points as seen from all points of another.
constexpr double kReachOfCells = 1.0;

/// Whether a body at the origin meets the open square of side 2 round (dx, dy).
[[nodiscard]] bool meets(const Body& body, int dx, int dy) {
  if (body.kind == Body::Kind::disc) {
    const double gx = std::max(std::abs(dx) - kReachOfCells, 0.0);
    const double gy = std::max(std::abs(dy) - kReachOfCells, 0.0);
    return gx * gx + gy * gy < body.radius * body.radius;
  }
  // Two convex shapes are apart if the sides of one of them part them.
  const double c = std::cos(body.yaw);
  const double s = std::sin(body.yaw);
  const double a = 0.5 * body.length;
  const double b = 0.5 * body.width;
  const double square = kReachOfCells * (std::abs(c) + std::abs(s));
  return std::abs(dx) < std::abs(c) * a + std::abs(s) * b + kReachOfCells &&
         std::abs(dy) < std::abs(s) * a + std::abs(c) * b + kReachOfCells &&
         std::abs(c * dx + s * dy) < a + square && std::abs(-s * dx + c * dy) < b + square;
}

void require_size(std::string_view name, double value) {
  require_within(name, value);
  if (!(value > 0.0)) {
    throw std::invalid_argument("a body needs lengths above 0");
  }
}

}  // namespace

Footprint::Footprint(const Body& body) {
  if (body.kind == Body::Kind::point) {
    rows_ = {{0, 0, 0}};
    return;
  }
  double reach = body.radius;
  if (body.kind == Body::Kind::disc) {
    require_size("body", body.radius);
  } else {
    require_size("body", body.length);
    require_size("body", body.width);
    if (!(std::abs(body.yaw) <= 10.0)) {
      throw std::invalid_argument("the yaw of a body is in radians, within +-10");
    }
    reach = 0.5 * std::hypot(body.length, body.width);
  }
  const int most = static_cast<int>(std::ceil(reach)) + 1;
  for (int dx = -most; dx <= most; ++dx) {
    int first = -most;
    int last = most;
    while (first <= last && !meets(body, dx, first)) {
      ++first;
    }
    while (last >= first && !meets(body, dx, last)) {
      --last;
    }
    if (first <= last) {
      rows_.push_back({dx, first, last});
    }
  }
}

CellSet standing_cells(const Grid& grid, const CellSet& ground, const Footprint& footprint) {
  if (footprint.is_point()) {
    return ground;
  }
  const auto is_ground = [&](int x, int y) {
    return grid.contains({x, y}) && ground[grid.index({x, y})] != 0;
  };
  // A body that stands on ground and reaches a cell that is none reaches, on the straight line
  // there, one at the border of the ground: only those are painted.
  RowCounts off(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Cell c = grid.cell(i);
    if (ground[i] != 0 || std::none_of(kSteps.begin(), kSteps.end(), [&](Cell step) {
          return is_ground(c.x + step.x, c.y + step.y);
        })) {
      continue;
    }
    for (const Footprint::Row& row : footprint.rows()) {
      const int x = c.x - row.dx;
      if (x >= 0 && x < grid.rows) {
        off.add(x, c.y - row.last, c.y - row.first);
      }
    }
  }
  CellSet standing = off.covered();
  int low = 0;
  int high = 0;
  for (const Footprint::Row& row : footprint.rows()) {
    low = std::min(low, row.first);
    high = std::max(high, row.last);
  }
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Cell c = grid.cell(i);
    const bool inside = c.x + footprint.rows().front().dx >= 0 &&
                        c.x + footprint.rows().back().dx < grid.rows && c.y + low >= 0 &&
                        c.y + high < grid.columns;
    standing[i] = ground[i] != 0 && standing[i] == 0 && inside ? 1 : 0;
  }
  return standing;
}

std::vector<double> least_under(const Grid& grid,
                                std::span<const double> values,
                                const CellSet& standing,
                                const Footprint& footprint) {
  std::vector<double> least(values.begin(), values.end());
  if (footprint.is_point()) {
    return least;
  }
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (standing[i] == 0) {
      continue;
    }
    const Cell c = grid.cell(i);
    for (const Footprint::Row& row : footprint.rows()) {
      const auto begin =
          values.begin() + static_cast<std::ptrdiff_t>(grid.index({c.x + row.dx, c.y + row.first}));
      least[i] = std::min(least[i], *std::min_element(begin, begin + (row.last - row.first + 1)));
    }
  }
  return least;
}

}  // namespace tcert::terrain
