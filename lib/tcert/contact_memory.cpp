#include <algorithm>
#include <bit>
#include <cmath>
#include <tcert/contact_memory.hpp>

namespace tcert {
namespace {

constexpr std::size_t kProbes = 16;
constexpr double kNothing = 1e-6;  // moves V_t by less than a micrometre

// Cells whose centres lie within a radius of a point, block by block.
class NearCells {
 public:
  NearCells(Point centre, double radius_m, double cell_m, std::int32_t side)
      : centre_(centre), square_m2_(radius_m * radius_m), cell_m_(cell_m), side_(side) {
    const double block_m = cell_m * side;
    low_x_ = index_of(centre.x_m - radius_m, block_m);
    high_x_ = index_of(centre.x_m + radius_m, block_m);
    low_y_ = index_of(centre.y_m - radius_m, block_m);
    high_y_ = index_of(centre.y_m + radius_m, block_m);
  }

  template <typename Visit>
  void for_each_block(Visit visit) const noexcept {
    for (std::int32_t by = low_y_; by <= high_y_; ++by) {
      for (std::int32_t bx = low_x_; bx <= high_x_; ++bx) {
        visit(bx, by);
      }
    }
  }

  // Columns of cells of all blocks together, and the offset of one from the centre; rows alike.
  [[nodiscard]] std::int32_t columns() const noexcept { return (high_x_ - low_x_ + 1) * side_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return (high_y_ - low_y_ + 1) * side_; }
  [[nodiscard]] double column_offset_m(std::int32_t column) const noexcept {
    return centre_of(low_x_, column) - centre_.x_m;
  }
  [[nodiscard]] double row_offset_m(std::int32_t row) const noexcept {
    return centre_of(low_y_, row) - centre_.y_m;
  }

  // Calls visit(cell within the block, its column, its row).
  template <typename Visit>
  void for_each_cell(std::int32_t bx, std::int32_t by, Visit visit) const noexcept {
    for (std::int32_t j = 0; j < side_; ++j) {
      const std::int32_t row = (by - low_y_) * side_ + j;
      const double dy = row_offset_m(row);
      for (std::int32_t i = 0; i < side_; ++i) {
        const std::int32_t column = (bx - low_x_) * side_ + i;
        const double dx = column_offset_m(column);
        if (dx * dx + dy * dy <= square_m2_) {
          visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(side_) +
                    static_cast<std::size_t>(i),
                static_cast<std::size_t>(column),
                static_cast<std::size_t>(row));
        }
      }
    }
  }

 private:
  static std::int32_t index_of(double at_m, double block_m) noexcept {
    constexpr double kFar = 2.0e8;
    return static_cast<std::int32_t>(std::clamp(std::floor(at_m / block_m), -kFar, kFar));
  }
  [[nodiscard]] double centre_of(std::int32_t block, std::int32_t within) const noexcept {
    return (static_cast<double>(block * side_ + within) + 0.5) * cell_m_;
  }

  Point centre_;
  double square_m2_;
  double cell_m_;
  std::int32_t side_;
  std::int32_t low_x_, high_x_, low_y_, high_y_;
};

}  // namespace

ContactMemory::ContactMemory(const CertificateParameters& parameters)
    : parameters_(parameters),
      blocks_(std::bit_ceil(
          std::max<std::size_t>(parameters.max_memory_cells / (kSide * kSide), kProbes))) {
  const double blocks = 6.0 * parameters.memory_sigma_m / (kSide * parameters.memory_cell_m);
  const std::size_t most = (static_cast<std::size_t>(blocks) + 3) * kSide;
  column_weights_.resize(most);
  row_weights_.resize(most);
}

void ContactMemory::clear() noexcept {
  if (!empty_) {
    std::fill(blocks_.begin(), blocks_.end(), Block{});
    empty_ = true;
    evicted_ = false;
  }
}

std::size_t ContactMemory::slot_of(std::int32_t bx, std::int32_t by) const noexcept {
  const auto x = static_cast<std::uint64_t>(static_cast<std::uint32_t>(bx));
  const auto y = static_cast<std::uint64_t>(static_cast<std::uint32_t>(by));
  std::uint64_t hash = (x << 32U | y) * 0x9E3779B97F4A7C15ULL;
  hash ^= hash >> 32U;
  return static_cast<std::size_t>(hash) & (blocks_.size() - 1);
}

const ContactMemory::Block* ContactMemory::find(std::int32_t bx, std::int32_t by) const noexcept {
  std::size_t slot = slot_of(bx, by);
  for (std::size_t probe = 0; probe < kProbes; ++probe) {
    const Block& block = blocks_[slot];
    if (block.halvings < 0.0) {
      return nullptr;
    }
    if (block.bx == bx && block.by == by) {
      return &block;
    }
    slot = (slot + 1) & (blocks_.size() - 1);
  }
  return nullptr;
}

// The block's own slot, a free one, or that of the faintest block nearby; faded to `halvings`.
ContactMemory::Block& ContactMemory::claim(std::int32_t bx,
                                           std::int32_t by,
                                           double halvings) noexcept {
  std::size_t slot = slot_of(bx, by);
  std::size_t faintest = slot;
  double least = 2.0;
  for (std::size_t probe = 0; probe < kProbes; ++probe) {
    const Block& block = blocks_[slot];
    if (block.halvings < 0.0 || (block.bx == bx && block.by == by)) {
      faintest = slot;
      break;
    }
    const double strongest = *std::max_element(block.values.begin(), block.values.end()) *
                             std::exp2(block.halvings - halvings);
    if (strongest < least) {
      least = strongest;
      faintest = slot;
    }
    slot = (slot + 1) & (blocks_.size() - 1);
  }
  Block& block = blocks_[faintest];
  if (block.halvings < 0.0 || block.bx != bx || block.by != by) {
    evicted_ = evicted_ || (block.halvings >= 0.0 && least > kNothing);
    block = Block{bx, by, halvings, {}};
    return block;
  }
  const double fading = std::exp2(block.halvings - halvings);
  for (double& value : block.values) {
    value *= fading;
  }
  block.halvings = halvings;
  return block;
}

void ContactMemory::add(Point point, double force_n, double time_s) noexcept {
  const double cap_n = parameters_.force_cap_n;
  const double force = std::isnan(force_n) ? cap_n : std::clamp(force_n, 0.0, cap_n);
  const double gain = parameters_.memory_gain * force / cap_n;
  const double halvings = time_s / parameters_.memory_half_life_s;
  const double sigma_m = parameters_.memory_sigma_m;
  const double per_square = -0.5 / (sigma_m * sigma_m);
  const NearCells near(point, 3.0 * sigma_m, parameters_.memory_cell_m, kSide);
  for (std::int32_t column = 0; column < near.columns(); ++column) {
    const double dx = near.column_offset_m(column);
    column_weights_[static_cast<std::size_t>(column)] = std::exp(per_square * dx * dx);
  }
  for (std::int32_t row = 0; row < near.rows(); ++row) {
    const double dy = near.row_offset_m(row);
    row_weights_[static_cast<std::size_t>(row)] = gain * std::exp(per_square * dy * dy);
  }
  near.for_each_block([&](std::int32_t bx, std::int32_t by) noexcept {
    Block& block = claim(bx, by, halvings);
    near.for_each_cell(bx, by, [&](std::size_t cell, std::size_t column, std::size_t row) noexcept {
      double& value = block.values[cell];
      value += (1.0 - value) * (row_weights_[row] * column_weights_[column]);
    });
  });
  empty_ = false;
}

double ContactMemory::largest_within(Point centre, double radius_m, double time_s) const noexcept {
  if (empty_) {
    return 0.0;
  }
  const double halvings = time_s / parameters_.memory_half_life_s;
  const NearCells near(centre, radius_m, parameters_.memory_cell_m, kSide);
  double largest = 0.0;
  near.for_each_block([&](std::int32_t bx, std::int32_t by) noexcept {
    const Block* block = find(bx, by);
    if (block == nullptr) {
      return;
    }
    double largest_here = 0.0;
    near.for_each_cell(bx, by, [&](std::size_t cell, std::size_t, std::size_t) noexcept {
      largest_here = std::max(largest_here, block->values[cell]);
    });
    if (largest_here > largest) {
      largest = std::max(largest, largest_here * std::exp2(block->halvings - halvings));
    }
  });
  return largest;
}

}  // namespace tcert
