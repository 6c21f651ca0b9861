#pragma once
/// \file
/// The access region S and the egress region G of a course: a disc or a simple polygon.

#include <tcert/geometry.hpp>
#include <variant>
#include <vector>

namespace tcert {

struct Disc {
  Point centre;
  double radius_m = 0.0;
};

/// Simple polygon, closed implicitly; at least three vertices, any winding.
struct Polygon {
  std::vector<Point> vertices;
};

using Region = std::variant<Disc, Polygon>;

/// True if `p` lies in the region; the boundary of a disc belongs to it. O(vertices).
[[nodiscard]] bool contains(const Region& region, Point p) noexcept;

}  // namespace tcert
