#pragma once
/// \file
/// Connected parts of a set of cells.

#include <cstdint>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// Cells that do not belong to the set.
inline constexpr std::int32_t kNoLabel = -1;

/// Label of every cell: 4-connected parts numbered from 0 in order of their first cell. O(cells).
[[nodiscard]] std::vector<std::int32_t> label_components(const Grid& grid, const CellSet& set);

/// The part of `set` that holds `seed`; empty (all 0) if the seed is not a member. O(part).
[[nodiscard]] CellSet component_of(const Grid& grid, const CellSet& set, Cell seed);

/// True if both cells belong to one part of `set`. \pre the grid contains `b`. O(part).
[[nodiscard]] bool are_joined(const Grid& grid, const CellSet& set, Cell a, Cell b);

/// `set` and the cells it encloses: those that cannot reach the edge of the grid outside it
/// (8-connected). O(cells).
[[nodiscard]] CellSet fill_holes(const Grid& grid, const CellSet& set);

}  // namespace tcert::terrain
