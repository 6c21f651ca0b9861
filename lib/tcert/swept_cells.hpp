#pragma once
/// \file
/// Which cells of a square grid are proven free, in blocks of 8 x 8 bits under a hash table.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tcert {

struct SweptCell {
  std::int32_t ix = 0;  ///< Covers [ix, ix + 1] cell widths in x.
  std::int32_t iy = 0;
  friend bool operator==(const SweptCell&, const SweptCell&) = default;
};

/// The constructor takes all memory. A cell for which there is no room left is not marked, and
/// full() says so: fewer cells are free then than could be, never more.
class SweptCells {
 public:
  static constexpr std::int32_t kSide = 8;  ///< Cells along a side of a block.

  /// Room for `max_cells` cells in whole blocks, if blocks are filled.
  explicit SweptCells(std::uint32_t max_cells);

  /// O(blocks in use).
  void clear() noexcept;

  void mark(SweptCell cell) noexcept { mark_run(cell.iy, cell.ix, cell.ix); }
  /// Marks the cells of row `iy` from `first` to `last`, both included. \pre last < 2^31 - 8.
  void mark_run(std::int32_t iy, std::int32_t first, std::int32_t last) noexcept;

  [[nodiscard]] bool contains(SweptCell cell) const noexcept;
  /// Bit iy * 8 + ix of a block: its cells that are marked. O(1).
  [[nodiscard]] std::uint64_t block(std::int32_t bx, std::int32_t by) const noexcept;

  [[nodiscard]] bool full() const noexcept { return full_; }

 private:
  static constexpr std::uint64_t kFree = 0x8000'0000'8000'0000ULL;  // beyond every block
  struct Block {
    std::uint64_t key = kFree;
    std::uint64_t cells = 0;
  };
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const noexcept;

  std::vector<Block> blocks_;        // open addressing; a power of two
  std::vector<std::uint32_t> used_;  // slots, for clear()
  std::size_t used_count_ = 0;
  bool full_ = false;
};

}  // namespace tcert
