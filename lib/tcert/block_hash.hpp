#pragma once
/// \file
/// Where a hash table of square blocks of cells looks for one first.

#include <cstdint>

namespace tcert {

/// One number for both indices of a block.
[[nodiscard]] inline std::uint64_t block_key(std::int32_t bx, std::int32_t by) noexcept {
  return std::uint64_t{static_cast<std::uint32_t>(bx)} << 32U | static_cast<std::uint32_t>(by);
}

/// Fibonacci hashing, its upper half folded into the lower, of which a table whose size is a power
/// of two takes its slot.
[[nodiscard]] inline std::uint64_t block_hash(std::uint64_t key) noexcept {
  const std::uint64_t hash = key * 0x9E3779B97F4A7C15ULL;
  return hash ^ hash >> 32U;
}

}  // namespace tcert
