#pragma once
/// \file
/// Square cells over the bounds of a world, and which of them its obstacles touch.

#include <cstddef>
#include <cstdint>
#include <tcert/region.hpp>
#include <vector>

#include "datasets/world.hpp"

namespace tcert::study {

/// Row-major cells; a strip narrower than a cell at the high bounds is left out.
struct CellGrid {
  Point origin;  ///< Low corner.
  double step_m = 0.0;
  std::size_t columns = 0;
  std::size_t rows = 0;

  [[nodiscard]] std::size_t size() const noexcept { return columns * rows; }
  [[nodiscard]] Point centre(std::size_t column, std::size_t row) const noexcept {
    return {origin.x_m + (static_cast<double>(column) + 0.5) * step_m,
            origin.y_m + (static_cast<double>(row) + 0.5) * step_m};
  }
  [[nodiscard]] Point centre(std::size_t cell) const noexcept {
    return centre(cell % columns, cell / columns);
  }
};

/// \throws std::invalid_argument unless there is a cell, and at most 2^27.
[[nodiscard]] CellGrid cell_grid(const World& world, double step_m);

/// 1 for each cell whose centre lies within `reach_m` of the region.
/// O(cells in the extent's rows + vertices x cells round the edges).
void mark_region(const CellGrid& grid,
                 const Region& region,
                 double reach_m,
                 std::vector<std::uint8_t>& marks);

/// Squared distance, in cells, from each centre to the centre of the nearest marked cell or of a
/// cell outside of the grid (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled
/// Functions, 2012). Exact. O(cells).
[[nodiscard]] std::vector<std::uint32_t> squared_distances(const CellGrid& grid,
                                                           const std::vector<std::uint8_t>& marks);

}  // namespace tcert::study
