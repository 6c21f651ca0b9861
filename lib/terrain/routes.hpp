#pragma once
/// \file
/// Ways over cells of a set: the shortest, and the widest.

#include <optional>
#include <span>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// The shortest way over `ground` from `from` to `to`, both included: steps to the four neighbours,
/// and diagonal ones where all four cells of the unit square belong to the ground, so that every
/// point of the way rounds to a cell of it. Empty if there is none. O(cells log cells).
[[nodiscard]] std::vector<Cell> shortest_route(const Grid& grid,
                                               const CellSet& ground,
                                               Cell from,
                                               Cell to);

/// Length of a polyline through cells.
[[nodiscard]] double route_length(const std::vector<Cell>& route) noexcept;

/// The largest m such that `from` and `to` are joined by a 4-connected way over `ground` along
/// which value - h >= m everywhere: the certificate of the start and the goal. Missing if they are
/// not joined. O(cells log cells).
[[nodiscard]] std::optional<double> widest_route(const Grid& grid,
                                                 const CellSet& ground,
                                                 std::span<const double> value,
                                                 double threshold,
                                                 Cell from,
                                                 Cell to);

/// The same from one cell to every cell: NaN where they are not joined. O(cells log cells).
[[nodiscard]] std::vector<double> widest_field(const Grid& grid,
                                               const CellSet& ground,
                                               std::span<const double> value,
                                               double threshold,
                                               Cell from);

}  // namespace tcert::terrain
