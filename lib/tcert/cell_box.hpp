#pragma once
/// \file
/// Cells of a grid as squares: how far they are from a segment, and whether a region covers them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tcert/region.hpp>
#include <tcert/segment.hpp>
#include <tcert/swept_cells.hpp>
#include <variant>

namespace tcert {

/// An upright square, such as a cell of a grid.
struct CellBox {
  Point low;
  Point high;
  [[nodiscard]] double distance_to(Point p) const noexcept {
    const double dx = std::max({low.x_m - p.x_m, 0.0, p.x_m - high.x_m});
    const double dy = std::max({low.y_m - p.y_m, 0.0, p.y_m - high.y_m});
    return std::sqrt(dx * dx + dy * dy);
  }
};

/// True if the segment from `a` to `b` has a point in the box.
[[nodiscard]] inline bool meets(const CellBox& box, Point a, Point b) noexcept {
  double from = 0.0;
  double to = 1.0;
  for (const auto axis : {&Point::x_m, &Point::y_m}) {
    const double start = a.*axis;
    const double way = b.*axis - start;
    if (way == 0.0) {
      if (start < box.low.*axis || start > box.high.*axis) {
        return false;
      }
      continue;
    }
    const double t0 = (box.low.*axis - start) / way;
    const double t1 = (box.high.*axis - start) / way;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
  return from <= to;
}

/// Between the box and the segment; 0 if they meet.
[[nodiscard]] inline double distance_between(const CellBox& box, Point a, Point b) noexcept {
  if (meets(box, a, b)) {
    return 0.0;
  }
  double least = std::min(box.distance_to(a), box.distance_to(b));
  for (const Point corner :
       {box.low, Point{box.high.x_m, box.low.y_m}, box.high, Point{box.low.x_m, box.high.y_m}}) {
    least = std::min(least, distance_to_segment(corner, a, b));
  }
  return least;
}

/// Of a cell of a grid of `cell_m`.
[[nodiscard]] inline CellBox box_of(SweptCell cell, double cell_m) noexcept {
  return {{static_cast<double>(cell.ix) * cell_m, static_cast<double>(cell.iy) * cell_m},
          {static_cast<double>(cell.ix + 1) * cell_m, static_cast<double>(cell.iy + 1) * cell_m}};
}

/// True if all of the box lies in the disc or region.
[[nodiscard]] inline bool covers(const Disc& disc, const CellBox& box) noexcept {
  const double dx = std::max(disc.centre.x_m - box.low.x_m, box.high.x_m - disc.centre.x_m);
  const double dy = std::max(disc.centre.y_m - box.low.y_m, box.high.y_m - disc.centre.y_m);
  return dx * dx + dy * dy <= disc.radius_m * disc.radius_m;
}

// The middle lies inside and every edge further off than the corners.
[[nodiscard]] inline bool covers(const Region& region, const CellBox& box) noexcept {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return covers(*disc, box);
  }
  const auto* const polygon = std::get_if<Polygon>(&region);
  const Point middle = 0.5 * (box.low + box.high);
  if (polygon == nullptr || !contains(region, middle)) {
    return false;
  }
  const double half_diagonal = distance(middle, box.low);
  const auto& v = polygon->vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    if (distance_to_segment(middle, v[j], v[i]) <= half_diagonal) {
      return false;
    }
  }
  return true;
}

}  // namespace tcert
