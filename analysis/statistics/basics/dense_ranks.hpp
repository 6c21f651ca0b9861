#pragma once
/// \file
/// Dense ranks within groups: the slots that rank statistics count in.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/basics/time_order.hpp>
#include <vector>

namespace tcert::statistics {

struct DenseRanks {
  std::vector<std::uint32_t> rank;    ///< Per row, from 0 in each group; equal values alike.
  std::vector<std::size_t> distinct;  ///< Distinct values per group.
};

/// Ranks `values` within the groups of `order`. O(n log n).
/// \throws std::invalid_argument if lengths differ or a value is NaN.
[[nodiscard]] DenseRanks dense_ranks(std::span<const double> values, const TimeOrder& order);

}  // namespace tcert::statistics
