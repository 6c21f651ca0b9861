#pragma once
/// \file
/// The square cells that a policy divides the box of a course into.

#include <cmath>
#include <cstdint>
#include <limits>
#include <tcert/lengths.hpp>
#include <tcert/policy_setup.hpp>

namespace tcert::policies {

/// Column and row of a cell: the cell of whole numbers (x, y) is centred at (x, y) * cell_m, so
/// that the mirrored point lies in the mirrored cell. A point on a border lies in the cell further
/// from the axis.
struct GridCell {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(const GridCell&, const GridCell&) = default;
  friend constexpr GridCell operator+(GridCell a, GridCell b) noexcept {
    return {a.x + b.x, a.y + b.y};
  }
};

class CourseGrid {
 public:
  static constexpr std::uint32_t kOutside = std::numeric_limits<std::uint32_t>::max();

  /// Cells of the box of the course and one more round it.
  /// \throws std::invalid_argument if they are more than max_policy_cells.
  explicit CourseGrid(const PolicySetup& setup);

  [[nodiscard]] double cell_m() const noexcept { return cell_m_; }
  [[nodiscard]] std::uint32_t cells() const noexcept { return columns_ * rows_; }

  /// \pre a usable pose's coordinates.
  [[nodiscard]] GridCell cell_at(Point p) const noexcept;
  [[nodiscard]] Point centre(GridCell cell) const noexcept {
    return {cell_m_ * cell.x, cell_m_ * cell.y};
  }
  /// kOutside if the grid does not hold it.
  [[nodiscard]] std::uint32_t index(GridCell cell) const noexcept;
  [[nodiscard]] GridCell cell(std::uint32_t index) const noexcept;
  /// The nearest cell that the grid holds.
  [[nodiscard]] GridCell clamped(GridCell cell) const noexcept;

 private:
  double cell_m_;
  GridCell low_;
  std::uint32_t columns_ = 0;
  std::uint32_t rows_ = 0;
};

/// Calls visit(offset) for every cell whose centre lies within `radius_m` of that of cell (0, 0); a
/// centre at just that distance does, whatever the last bit says.
template <typename Visit>
void for_each_offset_within(double radius_m, double cell_m, Visit visit) {
  const auto most = static_cast<std::int32_t>(std::ceil(radius_m / cell_m));
  for (std::int32_t y = -most; y <= most; ++y) {
    for (std::int32_t x = -most; x <= most; ++x) {
      if (!exceeds(cell_m * std::sqrt(x * x + y * y), radius_m)) {
        visit(GridCell{x, y});
      }
    }
  }
}

}  // namespace tcert::policies
