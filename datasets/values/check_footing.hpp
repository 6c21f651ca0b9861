#pragma once
/// \file
/// Slope, step and slip in other units than their columns say.

#include <optional>

#include "datasets/ticks.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// A finding about the first of: pitch or roll beyond a right angle, a step beyond 1 m, a slip
/// beyond 1.5. O(ticks); none of ticks without footing.
[[nodiscard]] std::optional<ValueFinding> check_footing(const TickTable& ticks);

}  // namespace tcert
