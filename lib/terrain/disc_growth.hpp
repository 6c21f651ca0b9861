#pragma once
/// \file
/// Lipschitz growth of the safe set, and the cells that could make it grow.

#include <cstdint>
#include <span>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// Cells x' with lower(x) - L |x - x'| >= h for some x of `safe`: Algorithm 1, line 6. Members
/// whose lower bound is below h drop out unless another disc holds them.
///
/// A disc whose radius is below the distance to the nearest cell outside is not drawn: it adds
/// nothing to what its members that stay make. `depth2` is squared_depth(grid, safe).
/// O(cells + drawn discs' radii); equals the union over all discs.
/// \pre lipschitz > 0
[[nodiscard]] CellSet grow_discs(const Grid& grid,
                                 const CellSet& safe,
                                 std::span<const double> lower,
                                 double threshold,
                                 double lipschitz,
                                 std::span<const std::int64_t> depth2);

/// Members x of `safe` for which upper(x) - L |x - x'| >= h for some x' outside: eq. (3.5), g > 0.
/// `depth2` is squared_depth(grid, safe). O(cells).
[[nodiscard]] CellSet expanders(const CellSet& safe,
                                std::span<const double> upper,
                                double threshold,
                                double lipschitz,
                                std::span<const std::int64_t> depth2);

/// True if bound - L sqrt(d2) >= h. An infinite bound reaches everything.
[[nodiscard]] bool reaches(double bound, double threshold, double lipschitz, double d2) noexcept;

}  // namespace tcert::terrain
