#pragma once
/// \file
/// C of predictors and their differences as a statistic, to be joined with AUCs of the same rows.

#include <cstddef>
#include <span>
#include <statistics/concordance/concordance.hpp>
#include <statistics/resampling/statistic.hpp>
#include <utility>
#include <vector>

namespace tcert::statistics {

/// Pairs of predictors, by index: the first's C minus the second's.
using ConcordanceDifferences = std::vector<std::pair<std::size_t, std::size_t>>;

/// Values: Harrell's C of each predictor, then each difference; NaN where a resample has no
/// comparable pair. Pairs are counted in whole numbers and divided once, so equal values are equal
/// bytes, and with every row once a C is that of `concordance` to the last bit. `strata` may be
/// null. A call is O(predictors x rows log rows) without allocation after the first, the jackknife
/// of all units the same. \throws std::invalid_argument as `ConcordanceReplicates` does, if there
/// is no predictor, or if a difference names one that is not there.
[[nodiscard]] Statistic concordance_statistic(const SurvivalOutcome& outcome,
                                              std::span<const Predictor> predictors,
                                              const ConcordanceDifferences& differences = {},
                                              const table::Factor* strata = nullptr);

}  // namespace tcert::statistics
