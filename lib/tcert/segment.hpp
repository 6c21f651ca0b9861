#pragma once
/// \file
/// Distances to straight segments.

#include <algorithm>
#include <tcert/geometry.hpp>

namespace tcert {

/// The point of the segment from `a` to `b` that is nearest to `p`; `a` if the segment is a point.
[[nodiscard]] inline Point nearest_on_segment(Point p, Point a, Point b) noexcept {
  const Point along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return a + t * along;
}

[[nodiscard]] inline double distance_to_segment(Point p, Point a, Point b) noexcept {
  return distance(p, nearest_on_segment(p, a, b));
}

}  // namespace tcert
