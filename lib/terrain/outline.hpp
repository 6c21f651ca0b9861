#pragma once
/// \file
/// Outlines of certified ground, with their holes.

#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// One part of the ground: an outer ring, counter-clockwise, and the rings of its holes, clockwise
/// (x to the right, y upwards). Rings are not closed and turn only at their corners.
struct Outline {
  std::vector<Cell> ring;
  std::vector<std::vector<Cell>> holes;
};

/// Outlines through cell centres of the union of all unit squares whose four corners belong to
/// `ground`: every point within rounds to a cell of it. Parts that touch at a corner alone are
/// separate; a hole is assigned to the part that surrounds it. In order of the first square.
/// O(cells + corners x parts).
[[nodiscard]] std::vector<Outline> outlines(const Grid& grid, const CellSet& ground);

/// Twice the signed area, positive for counter-clockwise.
[[nodiscard]] double doubled_area(const std::vector<Cell>& ring) noexcept;

/// True if segment a-b runs within that union of squares, its border included. O(length).
[[nodiscard]] bool runs_within(const Grid& grid, const CellSet& ground, Cell a, Cell b);

/// Douglas-Peucker on a ring, for a ring with the ground on its left: corners are left out while
/// they lie within `tolerance` of the chord, the chord runs within the ground, and it lies on the
/// ground's side of all of them, so that what is cut off was ground and what stays is certified.
[[nodiscard]] std::vector<Cell> simplified(const Grid& grid,
                                           const CellSet& ground,
                                           const std::vector<Cell>& ring,
                                           double tolerance);

}  // namespace tcert::terrain
