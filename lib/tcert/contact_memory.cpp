#include <algorithm>
#include <bit>
#include <cmath>
#include <tcert/contact_memory.hpp>

namespace tcert {
namespace {

constexpr std::size_t kProbes = 16;
constexpr double kLargestIndex = 2.0e9;

// Index of the first cell whose centre is not below `at`.
std::int32_t first_centre_from(double at, double cell_m) noexcept {
  const double index = std::ceil(at / cell_m - 0.5);
  return static_cast<std::int32_t>(std::clamp(index, -kLargestIndex, kLargestIndex));
}

std::int32_t last_centre_to(double at, double cell_m) noexcept {
  const double index = std::floor(at / cell_m - 0.5);
  return static_cast<std::int32_t>(std::clamp(index, -kLargestIndex, kLargestIndex));
}

double centre_of(std::int32_t index, double cell_m) noexcept {
  return (static_cast<double>(index) + 0.5) * cell_m;
}

}  // namespace

ContactMemory::ContactMemory(const CertificateParameters& parameters)
    : parameters_(parameters),
      cells_(std::bit_ceil(std::max<std::size_t>(parameters.max_memory_cells, kProbes))),
      weights_(
          static_cast<std::size_t>(6.0 * parameters.memory_sigma_m / parameters.memory_cell_m) +
          2) {}

void ContactMemory::clear() noexcept {
  if (!empty_) {
    std::fill(cells_.begin(), cells_.end(), Cell{});
    empty_ = true;
  }
}

std::size_t ContactMemory::slot_of(std::int32_t ix, std::int32_t iy) const noexcept {
  const auto x = static_cast<std::uint64_t>(static_cast<std::uint32_t>(ix));
  const auto y = static_cast<std::uint64_t>(static_cast<std::uint32_t>(iy));
  std::uint64_t hash = (x << 32U | y) * 0x9E3779B97F4A7C15ULL;
  hash ^= hash >> 32U;
  return static_cast<std::size_t>(hash) & (cells_.size() - 1);
}

const ContactMemory::Cell* ContactMemory::find(std::int32_t ix, std::int32_t iy) const noexcept {
  std::size_t slot = slot_of(ix, iy);
  for (std::size_t probe = 0; probe < kProbes; ++probe) {
    const Cell& cell = cells_[slot];
    if (!cell.used) {
      return nullptr;
    }
    if (cell.ix == ix && cell.iy == iy) {
      return &cell;
    }
    slot = (slot + 1) & (cells_.size() - 1);
  }
  return nullptr;
}

ContactMemory::Cell& ContactMemory::claim(std::int32_t ix,
                                          std::int32_t iy,
                                          double halvings) noexcept {
  std::size_t slot = slot_of(ix, iy);
  std::size_t faintest = slot;
  double least = 2.0;
  for (std::size_t probe = 0; probe < kProbes; ++probe) {
    Cell& cell = cells_[slot];
    if (!cell.used || (cell.ix == ix && cell.iy == iy)) {
      faintest = slot;
      break;
    }
    const double value = cell.value * std::exp2(cell.halvings - halvings);
    if (value < least) {
      least = value;
      faintest = slot;
    }
    slot = (slot + 1) & (cells_.size() - 1);
  }
  Cell& cell = cells_[faintest];
  if (!cell.used || cell.ix != ix || cell.iy != iy) {
    cell = {ix, iy, 0.0, halvings, true};
  }
  return cell;
}

void ContactMemory::add(Point point, double force_n, double time_s) noexcept {
  const double cap_n = parameters_.force_cap_n;
  const double force = std::isnan(force_n) ? cap_n : std::clamp(force_n, 0.0, cap_n);
  const double gain = parameters_.memory_gain * force / cap_n;
  const double halvings = time_s / parameters_.memory_half_life_s;
  const double cell_m = parameters_.memory_cell_m;
  const double sigma_m = parameters_.memory_sigma_m;
  const double cut_m = 3.0 * sigma_m;
  const double per_square = -0.5 / (sigma_m * sigma_m);
  const std::int32_t x0 = first_centre_from(point.x_m - cut_m, cell_m);
  const std::int32_t x1 = std::min(last_centre_to(point.x_m + cut_m, cell_m),
                                   x0 + static_cast<std::int32_t>(weights_.size()) - 1);
  const std::int32_t y0 = first_centre_from(point.y_m - cut_m, cell_m);
  const std::int32_t y1 = last_centre_to(point.y_m + cut_m, cell_m);
  for (std::int32_t ix = x0; ix <= x1; ++ix) {
    const double dx = centre_of(ix, cell_m) - point.x_m;
    weights_[static_cast<std::size_t>(ix - x0)] = std::exp(per_square * dx * dx);
  }
  for (std::int32_t iy = y0; iy <= y1; ++iy) {
    const double dy = centre_of(iy, cell_m) - point.y_m;
    const double row_gain = gain * std::exp(per_square * dy * dy);
    for (std::int32_t ix = x0; ix <= x1; ++ix) {
      const double dx = centre_of(ix, cell_m) - point.x_m;
      if (dx * dx + dy * dy > cut_m * cut_m) {
        continue;
      }
      Cell& cell = claim(ix, iy, halvings);
      const double faded = cell.value * std::exp2(cell.halvings - halvings);
      cell.value = faded + (1.0 - faded) * row_gain * weights_[static_cast<std::size_t>(ix - x0)];
      cell.halvings = halvings;
    }
  }
  empty_ = false;
}

double ContactMemory::largest_within(Point centre, double radius_m, double time_s) const noexcept {
  if (empty_) {
    return 0.0;
  }
  const double cell_m = parameters_.memory_cell_m;
  const double halvings = time_s / parameters_.memory_half_life_s;
  const std::int32_t x0 = first_centre_from(centre.x_m - radius_m, cell_m);
  const std::int32_t x1 = last_centre_to(centre.x_m + radius_m, cell_m);
  const std::int32_t y0 = first_centre_from(centre.y_m - radius_m, cell_m);
  const std::int32_t y1 = last_centre_to(centre.y_m + radius_m, cell_m);
  double largest = 0.0;
  for (std::int32_t iy = y0; iy <= y1; ++iy) {
    const double dy = centre_of(iy, cell_m) - centre.y_m;
    for (std::int32_t ix = x0; ix <= x1; ++ix) {
      const double dx = centre_of(ix, cell_m) - centre.x_m;
      if (dx * dx + dy * dy > radius_m * radius_m) {
        continue;
      }
      if (const Cell* cell = find(ix, iy)) {
        largest = std::max(largest, cell->value * std::exp2(cell->halvings - halvings));
      }
    }
  }
  return largest;
}

}  // namespace tcert
