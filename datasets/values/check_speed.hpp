#pragma once
/// \file
/// Poses that are too fast for a robot that feels its way.

#include <optional>

#include "datasets/ticks.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// A finding about x_m and y_m, from the speeds over half seconds, or over a fortieth of a shorter
/// log, between fresh ticks of a segment, ten of them at least: their median is above ten times
/// that of the commanded speeds, if these are known and not nearly 0, or above 5 m/s and not within
/// three times it. O(ticks).
[[nodiscard]] std::optional<ValueFinding> check_speed(const TickTable& ticks);

}  // namespace tcert
