#pragma once
/// \file
/// The certified motion: from one place in sight of a route to the next.

#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// Line-of-sight pursuit of the shortest route over `ground`: from where the robot stands straight
/// to the farthest cell of the route to which all points of the segment round to ground, and so on.
/// Positions from `from` to `to`; a single one if they are the same, none if they are not joined.
/// Never longer than the route. O(cells log cells + route^2 x length at worst). \pre `from` rounds
/// to a cell of the grid
[[nodiscard]] std::vector<Position> pursuit_way(const Grid& grid,
                                                const CellSet& ground,
                                                const Position& from,
                                                Cell to);

/// Every point of the segment rounds to a cell of the ground. O(length).
[[nodiscard]] bool stays_on_ground(const Grid& grid,
                                   const CellSet& ground,
                                   const Position& a,
                                   const Position& b);

/// Cells that the points of a segment round to, in order, that of `a` not among them. O(length).
[[nodiscard]] std::vector<Cell> cells_along(const Position& a, const Position& b);

[[nodiscard]] double length_of(const std::vector<Position>& way) noexcept;

}  // namespace tcert::terrain
