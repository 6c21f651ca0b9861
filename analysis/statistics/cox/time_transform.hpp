#pragma once
/// \file
/// Functions of time for the test of proportional hazards.

#include <statistics/cox/cox_zph.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

namespace tcert::statistics {

/// g at each row's `stop`, minus its mean over the rows with an event. \pre some event. O(n log n).
[[nodiscard]] std::vector<double> transformed_times(const SurvivalOutcome& outcome,
                                                    TimeTransform transform);

}  // namespace tcert::statistics
