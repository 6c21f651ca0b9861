#pragma once
/// \file
/// Three columns that are points x, y, value and not a terrain three cells wide.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/terrain_file.hpp"

namespace tcert::terrain_reading {

enum class PointList {
  none,     ///< Three columns of a terrain.
  lattice,  ///< Points on a lattice of even spacing, one value a node.
  broken,   ///< Points, or what may be some, that form no such lattice.
};

struct PointListResult {
  PointList kind = PointList::none;
  TerrainGrid terrain;  ///< Of a lattice: x along the first coordinate, y along the second.
  std::string note;     ///< Of a lattice: its origin and steps.
  std::string problem;  ///< Of a broken one, fit to follow "expected ".
};

/// `values` are rows of x, y, value. On a lattice: both coordinates evenly spaced (missing lines
/// allowed), one value a node (few of them said twice), a quarter of the nodes there, and as many
/// points as half again the longer side. Broken: points are `wanted` and there is none; or a few
/// nodes have two values; or no two lines begin alike and there are 16 or more of them, or their
/// three columns lie further apart than three times what any of them spans, which no terrain does.
/// O(n log n).
[[nodiscard]] PointListResult read_points(std::span<const double> values, bool wanted);

/// "x,y", "lon,lat", "easting,northing": the names of coordinates, in any case and quotes.
[[nodiscard]] bool names_coordinates(std::string_view first, std::string_view second);

}  // namespace tcert::terrain_reading
