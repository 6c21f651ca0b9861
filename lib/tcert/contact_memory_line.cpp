#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/cells_along.hpp>
#include <tcert/contact_memory.hpp>
#include <tcert/elementary.hpp>

namespace tcert {
namespace {

constexpr std::int32_t kSideBits = 2;  // a cell's block is its index without them
static_assert(1 << kSideBits == ContactMemory::kSide);

}  // namespace

double ContactMemory::mean_along(Point from,
                                 Point unit_direction,
                                 double length_m,
                                 double time_s) const noexcept {
  const double cell_m = parameters_.memory_cell_m;
  const double far_m = 1e8 * cell_m;
  if (used_.empty() || !(std::abs(from.x_m) + length_m < far_m) ||
      !(std::abs(from.y_m) + length_m < far_m)) {
    return 0.0;
  }
  const double halvings = time_s / parameters_.memory_half_life_s;
  const auto shifted = [&](std::int32_t x, std::int32_t y) noexcept {
    return integral_along(from, unit_direction, length_m, halvings, x, y);
  };
  const bool along_column = CellAxis(from.x_m, unit_direction.x_m, cell_m).on_border();
  const bool along_row = CellAxis(from.y_m, unit_direction.y_m, cell_m).on_border();
  if (along_column || along_row) {
    const double beside = along_column ? shifted(-1, 0) : shifted(0, -1);
    return 0.5 * (shifted(0, 0) + beside) / length_m;
  }
  return shifted(0, 0) / length_m;
}

double ContactMemory::integral_along(Point from,
                                     Point unit_direction,
                                     double length_m,
                                     double halvings,
                                     std::int32_t shift_x,
                                     std::int32_t shift_y) const noexcept {
  double integral = 0.0;
  const Block* block = nullptr;
  std::int32_t block_x = std::numeric_limits<std::int32_t>::max();
  std::int32_t block_y = block_x;
  double fading = 0.0;
  const auto add = [&](std::int32_t x, std::int32_t y, double part_m) noexcept {
    const std::int32_t column = x + shift_x;
    const std::int32_t row = y + shift_y;
    if (column >> kSideBits != block_x || row >> kSideBits != block_y) {
      block_x = column >> kSideBits;
      block_y = row >> kSideBits;
      block = find(block_x, block_y);
      fading = block == nullptr ? 0.0 : elementary::exp2(block->halvings - halvings);
    }
    if (block != nullptr && part_m > 0.0) {
      const auto within_row = static_cast<std::size_t>(row & (kSide - 1));
      const auto within_column = static_cast<std::size_t>(column & (kSide - 1));
      const std::size_t within = within_row * kSide + within_column;
      integral += part_m * (block->values[within] * fading);
    }
  };
  visit_cells_along(from, unit_direction, length_m, parameters_.memory_cell_m, add);
  return integral;
}

}  // namespace tcert
