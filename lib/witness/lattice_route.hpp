#pragma once
/// \file
/// Routes from S to G over the vertices of a distance field.

#include <optional>
#include <tcert/region.hpp>
#include <vector>
#include <witness/distance_field.hpp>

namespace tcert::witness {

/// Every `stride`-th vertex of a field, with its eight neighbours.
struct RouteGrid {
  const DistanceField& field;
  const Region& start;
  const Region& goal;
  int stride = 3;
};

/// The largest distance, in m, that a route from S to G can keep at all its vertices, by a widest
/// path search (max-min Dijkstra). Empty if no route keeps `least_m`. O(n log n), n vertices.
[[nodiscard]] std::optional<double> widest_value(const RouteGrid& grid, double least_m);

/// A short route of those that keep `least_m`; where it comes within 6 cm of that, a step counts up
/// to four times, so that the route takes the middle where that costs little. Empty if there is
/// none. O(n log n).
[[nodiscard]] std::vector<Point> short_route(const RouteGrid& grid, double least_m);

}  // namespace tcert::witness
