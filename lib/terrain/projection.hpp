#pragma once
/// \file
/// Cells deep within ground: where the published program measures instead of at the cell it chose.

#include <optional>
#include <terrain/grid.hpp>

namespace tcert::terrain {

/// The cell nearest to `target` (lowest index on ties) that lies at least `depth` within the
/// outlines of `safe`: outlines go through the centres of border cells and have no holes. None if
/// no cell lies that deep. O(cells).
[[nodiscard]] std::optional<Cell> projected_inwards(const Grid& grid,
                                                    const CellSet& safe,
                                                    Cell target,
                                                    double depth);

/// The same within `set` as it is, holes and all.
[[nodiscard]] std::optional<Cell> nearest_deep(const Grid& grid,
                                               const CellSet& set,
                                               Cell target,
                                               double depth);

}  // namespace tcert::terrain
