#pragma once
/// \file
/// How near a straight piece comes to what is not free. Part of the checker: nothing of the search.

#include <vector>
#include <witness/free_cells.hpp>

namespace tcert::witness {

/// The cells that are not free and touch a free one, at a side or a corner: of what is not free
/// nothing is nearer to a point of the free space, and no way leads out of it but through them.
class BorderCells {
 public:
  /// O(cells / 64 + cells of the border).
  explicit BorderCells(const FreeCells& cells);

  /// True if free cells lie along the border of the lattice, beyond which cells are not looked at.
  [[nodiscard]] bool are_cut() const noexcept { return cut_; }

  /// The distance of the segment a-b to the nearest of them, closed, 0 if it meets one; or `most_m`
  /// if none is nearer. O(cells of the border within that).
  [[nodiscard]] double distance_m(Point a, Point b, double most_m) const;

 private:
  Lattice lattice_;
  std::vector<std::vector<int>> columns_;  // by row
  bool cut_ = false;
};

}  // namespace tcert::witness
