#pragma once
/// \file
/// Exact Euclidean distances on the grid.

#include <cstdint>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// Squared distance of no cell: the set is empty.
inline constexpr std::int64_t kNoCell = std::int64_t{1} << 60;

/// Squared distance of every cell to the nearest cell of `set` (0 for its members). O(cells), exact
/// in integers (Meijster, Roerdink and Hesselink, 2000).
[[nodiscard]] std::vector<std::int64_t> squared_distance_transform(const Grid& grid,
                                                                   const CellSet& set);

/// The same to the nearest cell that does not belong to `set`; cells beyond the edge of the grid
/// do not count.
[[nodiscard]] std::vector<std::int64_t> squared_depth(const Grid& grid, const CellSet& set);

}  // namespace tcert::terrain
