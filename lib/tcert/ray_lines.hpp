#pragma once
/// \file
/// Two positions of a ray, and a square that it passes.

#include <cmath>
#include <limits>
#include <tcert/geometry.hpp>

namespace tcert {

/// Half the extent of an upright square of half-width 1 along the unit vector `u` or across it.
[[nodiscard]] inline double half_extent(Point u) noexcept {
  return std::abs(u.x_m) + std::abs(u.y_m);
}

/// How far along the first of two rays, from `a` along `u` and from `b` along `v`, the line of the
/// other crosses it; infinity if it does not.
[[nodiscard]] inline double crossing_m(Point a, Point u, Point b, Point v) noexcept {
  const double sine = cross(v, u);
  const double along_m = sine == 0.0 ? -1.0 : cross(v, b - a) / sine;
  return along_m >= 0.0 ? along_m : std::numeric_limits<double>::infinity();
}

}  // namespace tcert
