#pragma once
/// \file
/// Cells of a terrain, and positions between them. Unit of length: one cell.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tcert::terrain {

/// x is the row of the terrain file, y the column, both from 0.
struct Cell {
  int x = 0;
  int y = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// From a cell to its neighbours: those at its sides, then those at its corners.
inline constexpr std::array<Cell, 8> kSteps{
    {{-1, 0}, {0, -1}, {0, 1}, {1, 0}, {-1, -1}, {-1, 1}, {1, -1}, {1, 1}}};

/// A point of the plane; cell (x, y) has its centre at (x, y).
using Position = Eigen::Vector2d;

/// All integer points of [0, rows) x [0, columns), numbered row by row.
struct Grid {
  int rows = 0;
  int columns = 0;

  [[nodiscard]] std::size_t size() const noexcept {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  }
  [[nodiscard]] bool contains(Cell c) const noexcept {
    return c.x >= 0 && c.x < rows && c.y >= 0 && c.y < columns;
  }
  /// \pre contains(c)
  [[nodiscard]] std::size_t index(Cell c) const noexcept {
    return static_cast<std::size_t>(c.x) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(c.y);
  }
  [[nodiscard]] Cell cell(std::size_t index) const noexcept {
    const auto width = static_cast<std::size_t>(columns);
    return {static_cast<int>(index / width), static_cast<int>(index % width)};
  }
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// One byte a cell: 1 if it belongs to the set.
using CellSet = std::vector<std::uint8_t>;

[[nodiscard]] inline Position position(Cell c) noexcept {
  return {static_cast<double>(c.x), static_cast<double>(c.y)};
}
/// True if both coordinates are within +-1e6: far beyond any grid, and safe to be rounded.
[[nodiscard]] inline bool is_near(const Position& p) noexcept {
  return p.cwiseAbs().maxCoeff() <= 1e6 && p.allFinite();
}
/// The nearest cell; halves go to the even cell. May lie outside the grid. \pre is_near(p)
[[nodiscard]] inline Cell nearest_cell(const Position& p) noexcept {
  return {static_cast<int>(std::nearbyint(p.x())), static_cast<int>(std::nearbyint(p.y()))};
}
[[nodiscard]] inline double squared_distance(Cell a, Cell b) noexcept {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return dx * dx + dy * dy;
}
[[nodiscard]] inline double distance(Cell a, Cell b) noexcept {
  return std::sqrt(squared_distance(a, b));
}
[[nodiscard]] std::size_t count(const CellSet& set) noexcept;

}  // namespace tcert::terrain
