#pragma once
/// \file
/// A log that is much longer or shorter than its trial.

#include <optional>

#include "datasets/bundle.hpp"
#include "datasets/ticks.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// A finding if the trial's time_s, above 1 s, is more than ten times the time from the first tick
/// to the last, or less than a tenth of it. O(1).
[[nodiscard]] std::optional<ValueFinding> check_duration(const TrialRow& trial,
                                                         const TickTable& ticks);

}  // namespace tcert
