#pragma once
/// \file
/// Runs of cells painted row by row, in constant time a run. Internal.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// How many runs cover each cell, kept as differences along the rows.
class RowCounts {
 public:
  explicit RowCounts(const Grid& grid)
      : grid_(grid),
        width_(static_cast<std::size_t>(grid.columns) + 1),
        steps_(static_cast<std::size_t>(grid.rows) * width_, 0) {}

  [[nodiscard]] const Grid& grid() const noexcept { return grid_; }

  /// Columns `from` to `to` of row x, as far as they lie in the grid. \pre 0 <= x < rows, from <=
  /// to
  void add(int x, int from, int to) {
    if (to < 0 || from >= grid_.columns) {
      return;
    }
    const std::size_t start = static_cast<std::size_t>(x) * width_;
    ++steps_[start + static_cast<std::size_t>(std::max(from, 0))];
    --steps_[start + static_cast<std::size_t>(std::min(to, grid_.columns - 1) + 1)];
  }

  /// Cells that are covered. O(cells).
  [[nodiscard]] CellSet covered() const {
    CellSet set(grid_.size());
    for (int x = 0; x < grid_.rows; ++x) {
      const std::size_t from = static_cast<std::size_t>(x) * width_;
      std::int32_t over = 0;
      for (int y = 0; y < grid_.columns; ++y) {
        over += steps_[from + static_cast<std::size_t>(y)];
        set[grid_.index({x, y})] = over > 0 ? 1 : 0;
      }
    }
    return set;
  }

 private:
  Grid grid_;
  std::size_t width_;
  std::vector<std::int32_t> steps_;
};

}  // namespace tcert::terrain
