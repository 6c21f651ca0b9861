#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <tcert/block_hash.hpp>
#include <tcert/contact_memory.hpp>
#include <tcert/elementary.hpp>

namespace tcert {
namespace {

constexpr std::size_t kProbes = 16;
constexpr std::int32_t kSide = ContactMemory::kSide;
constexpr double kNothing = 1e-6;  // moves V_t by less than a micrometre

// Blocks of which a cell's centre may lie within a radius of a point.
class NearBlocks {
 public:
  NearBlocks(Point centre, double radius_m, double cell_m) : centre_(centre), cell_m_(cell_m) {
    const double block_m = cell_m * kSide;
    low_x_ = index_of(centre.x_m - radius_m, block_m);
    high_x_ = index_of(centre.x_m + radius_m, block_m);
    low_y_ = index_of(centre.y_m - radius_m, block_m);
    high_y_ = index_of(centre.y_m + radius_m, block_m);
  }

  template <typename Visit>
  void for_each(Visit visit) const noexcept {
    for (std::int32_t by = low_y_; by <= high_y_; ++by) {
      for (std::int32_t bx = low_x_; bx <= high_x_; ++bx) {
        visit(bx, by);
      }
    }
  }

  // Columns of cells of all blocks together, and the offset of one from the centre; rows alike.
  [[nodiscard]] std::int32_t columns() const noexcept { return (high_x_ - low_x_ + 1) * kSide; }
  [[nodiscard]] std::int32_t rows() const noexcept { return (high_y_ - low_y_ + 1) * kSide; }
  [[nodiscard]] double column_offset_m(std::int32_t column) const noexcept {
    return centre_of(low_x_, column) - centre_.x_m;
  }
  [[nodiscard]] double row_offset_m(std::int32_t row) const noexcept {
    return centre_of(low_y_, row) - centre_.y_m;
  }
  [[nodiscard]] std::size_t column_of(std::int32_t bx) const noexcept {
    return static_cast<std::size_t>(bx - low_x_) * kSide;
  }
  [[nodiscard]] std::size_t row_of(std::int32_t by) const noexcept {
    return static_cast<std::size_t>(by - low_y_) * kSide;
  }

  // Squared offsets of a block's cells from the centre, along x and along y.
  using Squares = std::array<double, kSide>;
  [[nodiscard]] Squares squares_x(std::int32_t bx) const noexcept {
    return squares(bx, centre_.x_m);
  }
  [[nodiscard]] Squares squares_y(std::int32_t by) const noexcept {
    return squares(by, centre_.y_m);
  }

 private:
  static std::int32_t index_of(double at_m, double block_m) noexcept {
    constexpr double kFar = 2.0e8;
    return static_cast<std::int32_t>(std::clamp(std::floor(at_m / block_m), -kFar, kFar));
  }
  [[nodiscard]] double centre_of(std::int32_t block, std::int32_t within) const noexcept {
    return (static_cast<double>(block * kSide + within) + 0.5) * cell_m_;
  }
  [[nodiscard]] Squares squares(std::int32_t block, double centre_m) const noexcept {
    Squares squares{};
    for (std::int32_t i = 0; i < kSide; ++i) {
      const double off_m = centre_of(block, i) - centre_m;
      squares[static_cast<std::size_t>(i)] = off_m * off_m;
    }
    return squares;
  }

  Point centre_;
  double cell_m_;
  std::int32_t low_x_, high_x_, low_y_, high_y_;
};

double least(const NearBlocks::Squares& squares) noexcept {
  return std::min({squares[0], squares[1], squares[2], squares[3]});
}

// factor exp(-d^2 / 2 sigma^2) at offsets d that are `step_m` apart. From the offset nearest to 0
// outward each is the one before times a ratio, and the ratio falls by exp(-step^2 / sigma^2):
// three exponentials for a row, and what underflows is nothing.
template <typename Offset>
void gaussian_row(Offset offset_m,
                  double step_m,
                  double sigma_m,
                  double factor,
                  double ratio_fall,
                  std::span<double> weights) noexcept {
  const double per_square = -0.5 / (sigma_m * sigma_m);
  const auto last = static_cast<double>(weights.size() - 1);
  const double nearest = std::clamp(std::round(-offset_m(0) / step_m), 0.0, last);
  const double off_m = offset_m(static_cast<std::int32_t>(nearest));
  const auto middle = static_cast<std::size_t>(nearest);
  weights[middle] = factor * elementary::exp(per_square * off_m * off_m);
  double ratio = elementary::exp(per_square * (step_m + 2.0 * off_m) * step_m);
  for (std::size_t i = middle + 1; i < weights.size(); ++i) {
    weights[i] = weights[i - 1] * ratio;
    ratio *= ratio_fall;
  }
  ratio = elementary::exp(per_square * (step_m - 2.0 * off_m) * step_m);
  for (std::size_t i = middle; i-- > 0;) {
    weights[i] = weights[i + 1] * ratio;
    ratio *= ratio_fall;
  }
}

}  // namespace

ContactMemory::ContactMemory(const CertificateParameters& parameters)
    : parameters_(parameters),
      blocks_(std::bit_ceil(
          std::max<std::size_t>(parameters.max_memory_cells / (kSide * kSide), kProbes))) {
  used_.reserve(blocks_.size());
  const double blocks = 6.0 * parameters.memory_sigma_m / (kSide * parameters.memory_cell_m);
  const std::size_t most = (static_cast<std::size_t>(blocks) + 3) * kSide;
  const double steps = parameters.memory_cell_m / parameters.memory_sigma_m;
  ratio_fall_ = elementary::exp(-steps * steps);
  column_weights_.resize(most);
  row_weights_.resize(most);
}

void ContactMemory::clear() noexcept {
  for (const std::uint32_t slot : used_) {
    blocks_[slot] = Block{};
  }
  used_.clear();
  evicted_ = false;
}

std::size_t ContactMemory::slot_of(std::int32_t bx, std::int32_t by) const noexcept {
  return static_cast<std::size_t>(block_hash(block_key(bx, by))) & (blocks_.size() - 1);
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
                             elementary::exp2(block.halvings - halvings);
    if (strongest < least) {
      least = strongest;
      faintest = slot;
    }
    slot = (slot + 1) & (blocks_.size() - 1);
  }
  Block& block = blocks_[faintest];
  if (block.halvings < 0.0 || block.bx != bx || block.by != by) {
    if (block.halvings < 0.0) {
      used_.push_back(static_cast<std::uint32_t>(faintest));
    }
    evicted_ = evicted_ || (block.halvings >= 0.0 && least > kNothing);
    block = Block{bx, by, halvings, {}};
    return block;
  }
  // Most blocks were last touched at the same tick: the power is the one of the block before.
  if (const double since = block.halvings - halvings; since != 0.0) {
    if (since != faded_since_) {
      faded_since_ = since;
      fading_ = elementary::exp2(since);
    }
    for (double& value : block.values) {
      value *= fading_;
    }
    block.halvings = halvings;
  }
  return block;
}

void ContactMemory::add(Point point, double force_n, double time_s) noexcept {
  const double cap_n = parameters_.force_cap_n;
  const double force = std::isnan(force_n) ? cap_n : std::clamp(force_n, 0.0, cap_n);
  const double gain = parameters_.memory_gain * force / cap_n;
  const double halvings = time_s / parameters_.memory_half_life_s;
  const double sigma_m = parameters_.memory_sigma_m;
  const double cell_m = parameters_.memory_cell_m;
  const double radius_m = 3.0 * sigma_m;
  const double square_m2 = radius_m * radius_m;
  const NearBlocks near(point, radius_m, cell_m);
  const std::span column_weights =
      std::span(column_weights_).first(static_cast<std::size_t>(near.columns()));
  const std::span row_weights =
      std::span(row_weights_).first(static_cast<std::size_t>(near.rows()));
  gaussian_row([&](std::int32_t column) { return near.column_offset_m(column); },
               cell_m,
               sigma_m,
               1.0,
               ratio_fall_,
               column_weights);
  gaussian_row([&](std::int32_t row) { return near.row_offset_m(row); },
               cell_m,
               sigma_m,
               gain,
               ratio_fall_,
               row_weights);
  near.for_each([&](std::int32_t bx, std::int32_t by) noexcept {
    const NearBlocks::Squares dx2 = near.squares_x(bx);
    const NearBlocks::Squares dy2 = near.squares_y(by);
    if (least(dx2) + least(dy2) > square_m2) {
      return;
    }
    Block& block = claim(bx, by, halvings);
    const double* const columns = column_weights.data() + near.column_of(bx);
    const double* const rows = row_weights.data() + near.row_of(by);
    for (std::size_t j = 0; j < kSide; ++j) {
      for (std::size_t i = 0; i < kSide; ++i) {
        double& value = block.values[j * kSide + i];
        const double weight = rows[j] * columns[i];
        value += (1.0 - value) * (dx2[i] + dy2[j] <= square_m2 ? weight : 0.0);
      }
    }
  });
}

double ContactMemory::largest_within(Point centre, double radius_m, double time_s) const noexcept {
  if (used_.empty()) {
    return 0.0;
  }
  const double halvings = time_s / parameters_.memory_half_life_s;
  const double square_m2 = radius_m * radius_m;
  const NearBlocks near(centre, radius_m, parameters_.memory_cell_m);
  double largest = 0.0;
  near.for_each([&](std::int32_t bx, std::int32_t by) noexcept {
    const NearBlocks::Squares dx2 = near.squares_x(bx);
    const NearBlocks::Squares dy2 = near.squares_y(by);
    if (least(dx2) + least(dy2) > square_m2) {
      return;
    }
    const Block* const block = find(bx, by);
    if (block == nullptr) {
      return;
    }
    double largest_here = 0.0;
    for (std::size_t j = 0; j < kSide; ++j) {
      for (std::size_t i = 0; i < kSide; ++i) {
        const double value = block->values[j * kSide + i];
        const double within = dx2[i] + dy2[j] <= square_m2 ? value : 0.0;
        largest_here = within > largest_here ? within : largest_here;
      }
    }
    if (largest_here > largest) {
      largest = std::max(largest, largest_here * elementary::exp2(block->halvings - halvings));
    }
  });
  return largest;
}

}  // namespace tcert
