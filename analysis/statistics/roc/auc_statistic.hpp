#pragma once
/// \file
/// AUCs of predictors and their differences as a statistic: sorted once, then reweighted.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/resampling/statistic.hpp>
#include <statistics/roc/roc.hpp>
#include <utility>
#include <vector>

namespace tcert::statistics {

/// Pairs of predictors, by index: the first's AUC minus the second's.
using AucDifferences = std::vector<std::pair<std::size_t, std::size_t>>;

/// Values: the AUC of each score, then each difference; NaN where a resample has one class. Pairs
/// of rows are counted in whole numbers and divided once, so equal values are equal bytes, and with
/// every row once an AUC is that of `auc` to the last bit. A call is O(scores x rows) without
/// allocation; all units left out one by one as well.
/// \throws std::invalid_argument if lengths differ, a score is NaN, a difference names a score that
/// is not there, or there are 2^30 rows or more.
[[nodiscard]] Statistic auc_statistic(std::span<const Score> scores,
                                      std::span<const std::uint8_t> success,
                                      const AucDifferences& differences = {});

}  // namespace tcert::statistics
