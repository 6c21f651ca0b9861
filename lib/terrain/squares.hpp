#pragma once
/// \file
/// Squares of the grid between four members of a set. Internal to outline.cpp.

#include <cstddef>
#include <terrain/grid.hpp>

namespace tcert::terrain {

/// Squares of four members, named by their lowest corner.
class Squares {
 public:
  Squares(const Grid& grid, const CellSet& ground) : grid_(grid), ground_(ground) {}

  [[nodiscard]] bool operator()(int x, int y) const {
    if (x < 0 || y < 0 || x + 1 >= grid_.rows || y + 1 >= grid_.columns) {
      return false;
    }
    const std::size_t i = grid_.index({x, y});
    const auto width = static_cast<std::size_t>(grid_.columns);
    return ground_[i] != 0 && ground_[i + 1] != 0 && ground_[i + width] != 0 &&
           ground_[i + width + 1] != 0;
  }

  /// The squares left and right of the edge that leaves `from` in direction d.
  [[nodiscard]] bool left(Cell from, int d) const {
    switch (d) {
      case 0:
        return (*this)(from.x, from.y);
      case 1:
        return (*this)(from.x - 1, from.y);
      case 2:
        return (*this)(from.x - 1, from.y - 1);
      default:
        return (*this)(from.x, from.y - 1);
    }
  }
  [[nodiscard]] bool right(Cell from, int d) const { return left(from, (d + 3) % 4); }

 private:
  const Grid& grid_;
  const CellSet& ground_;
};

}  // namespace tcert::terrain
