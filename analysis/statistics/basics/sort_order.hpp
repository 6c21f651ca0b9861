#pragma once
/// \file
/// The order of a column of numbers: the first step of every rank statistic.

#include <cstdint>
#include <span>
#include <vector>

namespace tcert::statistics {

/// Row indices by ascending value, equal values in row order. Infinities are at the ends, -0 equals
/// 0. A radix sort of the leading 32 bits, then of what they leave equal: O(n) unless values differ
/// in their last bits only, never worse than O(n log n).
/// \throws std::invalid_argument if a value is NaN or there are 2^32 rows or more.
[[nodiscard]] std::vector<std::uint32_t> sort_order(std::span<const double> values);

}  // namespace tcert::statistics
