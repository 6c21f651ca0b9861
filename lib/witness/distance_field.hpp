#pragma once
/// \file
/// How far the corners of cells are from what is not free.

#include <cstddef>
#include <vector>
#include <witness/free_cells.hpp>

namespace tcert::witness {

/// The distance in m from each vertex of the lattice, (columns + 1) x (rows + 1) row-major, to the
/// closed union of the cells that are not free; the border of the lattice is not free. It is exact
/// but for the rounding to float, since the point of a cell that is nearest to a vertex is a
/// vertex.
class DistanceField {
 public:
  /// Two passes of the lower envelope of parabolas, in whole cells (Felzenszwalb and Huttenlocher
  /// 2012). O(cells) time, 8 bytes a vertex.
  explicit DistanceField(const FreeCells& cells);

  [[nodiscard]] int columns() const noexcept { return columns_; }  ///< Of vertices.
  [[nodiscard]] int rows() const noexcept { return rows_; }
  [[nodiscard]] Point position(int ix, int iy) const noexcept { return lattice_.corner(ix, iy); }
  [[nodiscard]] double at_vertex(int ix, int iy) const noexcept {
    return static_cast<double>(
        distance_m_[static_cast<std::size_t>(iy) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(ix)]);
  }
  [[nodiscard]] double cell_m() const noexcept { return lattice_.cell_m; }

  /// Bilinear between vertices; 0 outside. It differs from the distance by at most a cell's
  /// diagonal.
  [[nodiscard]] double at(Point p) const noexcept;

  /// Gradient of at() by central differences over `step_m` to either side.
  [[nodiscard]] Point gradient(Point p, double step_m) const noexcept;

 private:
  Lattice lattice_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> distance_m_;
};

}  // namespace tcert::witness
