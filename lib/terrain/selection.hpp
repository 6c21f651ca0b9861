#pragma once
/// \file
/// Which cell to measure next.

#include <cstddef>
#include <optional>
#include <terrain/confidence.hpp>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

enum class Ties {
  nearest_first,    ///< Equal widths: the nearest to the goal, then the lowest index.
  row_major_first,  ///< Equal widths: the lowest index.
};

/// The `n` cells of `candidates` nearest to `goal`, ties by index; in order of index.
/// O(candidates).
[[nodiscard]] std::vector<std::size_t> nearest_cells(const Grid& grid,
                                                     std::vector<std::size_t> candidates,
                                                     Cell goal,
                                                     std::size_t n);

/// The `n` cells of `candidates` with the widest intervals, ties by index; in order of index.
/// O(candidates).
[[nodiscard]] std::vector<std::size_t> widest_cells(std::vector<std::size_t> candidates,
                                                    const Intervals& intervals,
                                                    std::size_t n);

/// The widest interval among `candidates` (in order of index); none if there are none. Widths that
/// differ by rounding (1e-10 of themselves) are ties; without a goal they go to the lowest index.
[[nodiscard]] std::optional<std::size_t> widest_cell(const Grid& grid,
                                                     const std::vector<std::size_t>& candidates,
                                                     const Intervals& intervals,
                                                     std::optional<Cell> goal,
                                                     Ties ties);

/// Indices of the members of a set, ascending.
[[nodiscard]] std::vector<std::size_t> members(const CellSet& set);

}  // namespace tcert::terrain
