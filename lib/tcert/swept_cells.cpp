#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <tcert/block_hash.hpp>
#include <tcert/swept_cells.hpp>

namespace tcert {
namespace {

constexpr std::size_t kProbes = 16;
constexpr std::size_t kCellsPerBlock = 64;

std::int32_t block_of(std::int32_t cell) noexcept { return cell >> 3; }
std::uint32_t within(std::int32_t cell) noexcept { return static_cast<std::uint32_t>(cell) & 7U; }

}  // namespace

SweptCells::SweptCells(std::uint32_t max_cells)
    : blocks_(std::bit_ceil(std::max<std::size_t>(max_cells / kCellsPerBlock, kProbes))),
      used_(blocks_.size()) {}

void SweptCells::clear() noexcept {
  for (std::size_t i = 0; i < used_count_; ++i) {
    blocks_[used_[i]] = {};
  }
  used_count_ = 0;
  full_ = false;
}

std::size_t SweptCells::slot_of(std::uint64_t key) const noexcept {
  return static_cast<std::size_t>(block_hash(key)) & (blocks_.size() - 1);
}

std::uint64_t SweptCells::block(std::int32_t bx, std::int32_t by) const noexcept {
  const std::uint64_t key = block_key(bx, by);
  std::size_t slot = slot_of(key);
  for (std::size_t probe = 0; probe < kProbes; ++probe) {
    if (blocks_[slot].key == key || blocks_[slot].key == kFree) {
      return blocks_[slot].cells;
    }
    slot = (slot + 1) & (blocks_.size() - 1);
  }
  return 0;
}

bool SweptCells::contains(SweptCell cell) const noexcept {
  const std::uint32_t bit = within(cell.iy) * 8U + within(cell.ix);
  return (block(block_of(cell.ix), block_of(cell.iy)) >> bit & 1U) != 0;
}

void SweptCells::mark_run(std::int32_t iy, std::int32_t first, std::int32_t last) noexcept {
  assert(last <= std::numeric_limits<std::int32_t>::max() - kSide);
  const std::int32_t by = block_of(iy);
  for (std::int32_t bx = block_of(first); first <= last; ++bx) {
    const std::int32_t end = std::min(last, bx * kSide + kSide - 1);
    const std::uint64_t ones =
        (std::uint64_t{2} << within(end)) - (std::uint64_t{1} << within(first));
    const std::uint64_t cells = ones << (8U * within(iy));
    first = end + 1;

    const std::uint64_t key = block_key(bx, by);
    std::size_t slot = slot_of(key);
    std::size_t probe = 0;
    while (probe < kProbes && blocks_[slot].key != key && blocks_[slot].key != kFree) {
      slot = (slot + 1) & (blocks_.size() - 1);
      ++probe;
    }
    if (probe == kProbes) {
      full_ = true;
      continue;
    }
    if (blocks_[slot].key == kFree) {
      blocks_[slot].key = key;
      used_[used_count_++] = static_cast<std::uint32_t>(slot);
    }
    blocks_[slot].cells |= cells;
  }
}

}  // namespace tcert
