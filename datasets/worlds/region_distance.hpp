#pragma once
/// \file
/// Distances from points to discs and polygons.

#include <tcert/region.hpp>

namespace tcert {

/// Distance to a region; 0 inside. O(vertices).
[[nodiscard]] double region_distance(const Region& region, Point p) noexcept;

/// Distance between two regions; 0 if they touch or overlap. O(vertices of a x vertices of b).
[[nodiscard]] double region_gap(const Region& a, const Region& b) noexcept;

/// True if the segments a-b and c-d have a point in common.
[[nodiscard]] bool segments_meet(Point a, Point b, Point c, Point d) noexcept;

/// The smallest rectangle round a region.
struct Extent {
  Point low;
  Point high;
};
[[nodiscard]] Extent extent_of(const Region& region) noexcept;

}  // namespace tcert
