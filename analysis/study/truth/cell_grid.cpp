#include "analysis/study/truth/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tcert/segment.hpp>

#include "datasets/worlds/region_distance.hpp"

namespace tcert::study {
namespace {

constexpr double kMostCells = 134'217'728.0;

/// Cells whose centres may lie in [low, high], as [first, last).
struct Span {
  std::size_t first = 0;
  std::size_t last = 0;
};

Span span_of(double origin, double step, std::size_t count, double low, double high) {
  const auto n = static_cast<double>(count);
  const double first = std::clamp(std::floor((low - origin) / step - 0.5), 0.0, n);
  const double last = std::clamp(std::ceil((high - origin) / step + 0.5), first, n);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

Span columns_of(const CellGrid& grid, double low, double high) {
  return span_of(grid.origin.x_m, grid.step_m, grid.columns, low, high);
}

Span rows_of(const CellGrid& grid, double low, double high) {
  return span_of(grid.origin.y_m, grid.step_m, grid.rows, low, high);
}

void mark_disc(const CellGrid& grid, const Disc& disc, std::vector<std::uint8_t>& marks) {
  const Span rows = rows_of(grid, disc.centre.y_m - disc.radius_m, disc.centre.y_m + disc.radius_m);
  const Span columns =
      columns_of(grid, disc.centre.x_m - disc.radius_m, disc.centre.x_m + disc.radius_m);
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    for (std::size_t column = columns.first; column < columns.last; ++column) {
      if (contains(Region(disc), grid.centre(column, row))) {
        marks[row * grid.columns + column] = 1;
      }
    }
  }
}

void mark_edge(
    const CellGrid& grid, Point a, Point b, double reach, std::vector<std::uint8_t>& marks) {
  const Span rows = rows_of(grid, std::min(a.y_m, b.y_m) - reach, std::max(a.y_m, b.y_m) + reach);
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    // The part of the edge within reach of this row's line bounds the columns.
    const double y = grid.centre(0, row).y_m;
    double from = 0.0;
    double to = 1.0;
    if (const double dy = b.y_m - a.y_m; dy != 0.0) {
      const double s = (y - reach - a.y_m) / dy;
      const double t = (y + reach - a.y_m) / dy;
      from = std::clamp(std::min(s, t), 0.0, 1.0);
      to = std::clamp(std::max(s, t), 0.0, 1.0);
    }
    const double p = a.x_m + from * (b.x_m - a.x_m);
    const double q = a.x_m + to * (b.x_m - a.x_m);
    const Span columns = columns_of(grid, std::min(p, q) - reach, std::max(p, q) + reach);
    for (std::size_t column = columns.first; column < columns.last; ++column) {
      const Point centre = grid.centre(column, row);
      if (distance_to_segment(centre, a, b) <= reach) {
        marks[row * grid.columns + column] = 1;
      }
    }
  }
}

void mark_inside(const CellGrid& grid, const Polygon& polygon, std::vector<std::uint8_t>& marks) {
  const Extent extent = extent_of(Region(polygon));
  const Span rows = rows_of(grid, extent.low.y_m, extent.high.y_m);
  const auto& v = polygon.vertices;
  std::vector<double> crossings;
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    const double y = grid.centre(0, row).y_m;
    crossings.clear();
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
      if ((v[i].y_m > y) != (v[j].y_m > y)) {
        crossings.push_back(v[i].x_m +
                            (y - v[i].y_m) / (v[j].y_m - v[i].y_m) * (v[j].x_m - v[i].x_m));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const Span columns = columns_of(grid, crossings[k], crossings[k + 1]);
      for (std::size_t column = columns.first; column < columns.last; ++column) {
        const double x = grid.centre(column, row).x_m;
        if (crossings[k] <= x && x <= crossings[k + 1]) {
          marks[row * grid.columns + column] = 1;
        }
      }
    }
  }
}

}  // namespace

CellGrid cell_grid(const World& world, double step_m) {
  const Point size = world.bounds.high - world.bounds.low;
  const double columns = std::floor(size.x_m / step_m);
  const double rows = std::floor(size.y_m / step_m);
  if (!(step_m > 0.0) || !(columns >= 1.0) || !(rows >= 1.0) || !(columns * rows <= kMostCells)) {
    throw std::invalid_argument("world '" + world.name + "': expected a step of at least " +
                                std::to_string(std::sqrt(size.x_m * size.y_m / kMostCells)) +
                                " m and at most the smaller side of the bounds, found " +
                                std::to_string(step_m));
  }
  return {
      world.bounds.low, step_m, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)};
}

void mark_region(const CellGrid& grid,
                 const Region& region,
                 double reach_m,
                 std::vector<std::uint8_t>& marks) {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    mark_disc(grid, {disc->centre, disc->radius_m + reach_m}, marks);
    return;
  }
  const auto& polygon = std::get<Polygon>(region);
  mark_inside(grid, polygon, marks);
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    mark_edge(grid, v[j], v[i], reach_m, marks);
  }
}

std::vector<std::uint32_t> squared_distances(const CellGrid& grid,
                                             const std::vector<std::uint8_t>& marks) {
  const std::size_t columns = grid.columns;
  const std::size_t rows = grid.rows;
  // Along columns: cells to the nearest marked cell, or to the row outside.
  std::vector<std::uint32_t> result(grid.size());
  for (std::size_t column = 0; column < columns; ++column) {
    std::uint32_t since = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t cell = row * columns + column;
      since = marks[cell] != 0 ? 0 : since + 1;
      result[cell] = since;
    }
    since = 0;
    for (std::size_t row = rows; row-- > 0;) {
      const std::size_t cell = row * columns + column;
      since = marks[cell] != 0 ? 0 : since + 1;
      result[cell] = std::min(result[cell], since);
    }
  }
  // Along rows: the lower envelope of parabolas, with a cell of 0 outside at either end.
  const std::size_t sites = columns + 2;
  std::vector<double> height(sites);
  std::vector<std::size_t> site(sites);
  std::vector<double> from(sites + 1);
  for (std::size_t row = 0; row < rows; ++row) {
    std::uint32_t* const line = result.data() + row * columns;
    height[0] = height[sites - 1] = 0.0;
    for (std::size_t column = 0; column < columns; ++column) {
      height[column + 1] = static_cast<double>(line[column]) * static_cast<double>(line[column]);
    }
    std::size_t last = 0;
    site[0] = 0;
    from[0] = -HUGE_VAL;
    from[1] = HUGE_VAL;
    const auto meet = [&](std::size_t p, std::size_t q) {
      const auto x = static_cast<double>(p);
      const auto y = static_cast<double>(q);
      return ((height[q] + y * y) - (height[p] + x * x)) / (2.0 * (y - x));
    };
    for (std::size_t q = 1; q < sites; ++q) {
      double s = meet(site[last], q);
      while (s <= from[last]) {
        --last;
        s = meet(site[last], q);
      }
      ++last;
      site[last] = q;
      from[last] = s;
      from[last + 1] = HUGE_VAL;
    }
    std::size_t k = 0;
    for (std::size_t column = 0; column < columns; ++column) {
      const auto x = static_cast<double>(column + 1);
      while (from[k + 1] < x) {
        ++k;
      }
      const double d = x - static_cast<double>(site[k]);
      line[column] = static_cast<std::uint32_t>(d * d + height[site[k]]);
    }
  }
  return result;
}

}  // namespace tcert::study
