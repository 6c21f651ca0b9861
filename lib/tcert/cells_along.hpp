#pragma once
/// \file
/// The cells of a square grid that a straight line crosses, in their order.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tcert/geometry.hpp>

namespace tcert {

/// The cells that a straight line crosses along one axis. A border is computed from its index and
/// not from the one before, so that nothing adds up.
class CellAxis {
 public:
  /// \pre |from_m| < 10^9 cells.
  CellAxis(double from_m, double slope, double cell_m) noexcept
      : from_m_(from_m), slope_(slope), cell_m_(cell_m) {
    cell_ = static_cast<std::int32_t>(std::floor(from_m / cell_m));
  }

  [[nodiscard]] std::int32_t cell() const noexcept { return cell_; }
  /// How far along the line it leaves the cell.
  [[nodiscard]] double leaves_m() const noexcept {
    if (slope_ == 0.0) {
      return std::numeric_limits<double>::infinity();
    }
    const std::int32_t border = slope_ > 0.0 ? cell_ + 1 : cell_;
    return (border * cell_m_ - from_m_) / slope_;
  }
  void advance() noexcept { cell_ += slope_ > 0.0 ? 1 : -1; }

  /// The line runs along the border between a cell and the one below.
  [[nodiscard]] bool on_border() const noexcept {
    return slope_ == 0.0 && from_m_ / cell_m_ == std::floor(from_m_ / cell_m_);
  }

 private:
  double from_m_;
  double slope_;
  double cell_m_;
  std::int32_t cell_;
};

/// visit(column, row, part_m) of each cell that the line enters, `part_m` >= 0 of it within; the
/// parts add up to `length_m` but for rounding. O(cells along the line).
/// \pre finite numbers within 10^8 cells, a unit vector.
template <typename Visit>
void visit_cells_along(
    Point from, Point unit_direction, double length_m, double cell_m, Visit visit) noexcept {
  CellAxis x(from.x_m, unit_direction.x_m, cell_m);
  CellAxis y(from.y_m, unit_direction.y_m, cell_m);
  for (double at_m = 0.0; at_m < length_m;) {
    const double leaves_m = std::min({x.leaves_m(), y.leaves_m(), length_m});
    visit(x.cell(), y.cell(), std::max(leaves_m - at_m, 0.0));
    at_m = std::max(at_m, leaves_m);
    (x.leaves_m() <= y.leaves_m() ? x : y).advance();
  }
}

}  // namespace tcert
