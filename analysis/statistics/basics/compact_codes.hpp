#pragma once
/// \file
/// Codes of groups without gaps.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert::statistics {

struct CompactCodes {
  std::vector<std::uint32_t> codes;  ///< One a row, below `count`; every number has a row.
  std::size_t count = 0;
};

/// Numbers groups from 0 in the order of their codes. \throws std::invalid_argument if a code is
/// Factor::kMissing. O(rows + largest code).
[[nodiscard]] CompactCodes compact_codes(std::span<const std::uint32_t> codes);

/// How many different codes there are: the clusters among rows. O(rows + largest
/// code).
[[nodiscard]] std::size_t count_codes(std::span<const std::uint32_t> codes);

}  // namespace tcert::statistics
