#pragma once
/// \file
/// The order of rows by a score.

#include <cstdint>
#include <span>
#include <statistics/roc/placements.hpp>
#include <vector>

namespace tcert::statistics {

/// Rows from the weakest evidence of success to the strongest; tied rows in row order. O(n log n).
/// \pre scores are not NaN, fewer than 2^32 rows.
[[nodiscard]] std::vector<std::uint32_t> rank_order(std::span<const double> score,
                                                    HigherMeans higher);

}  // namespace tcert::statistics
