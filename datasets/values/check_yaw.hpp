#pragma once
/// \file
/// Headings that do not follow the motion.

#include <optional>

#include "datasets/ticks.hpp"
#include "datasets/values/value_finding.hpp"

namespace tcert {

/// A finding about yaw_rad, from the steps of 5 cm and more between fresh ticks of a segment; a
/// robot drives ahead or back along the mean of its headings. With 20 such steps and more:
///
/// - *degrees*: yaw is beyond 7 rad, and read as degrees it follows the motion (within 15 degrees
/// at
///   most steps), while as radians it does not (20 degrees off at most steps);
/// - *degrees or another frame*: the angle to the motion is over 45 degrees at most steps.
///
/// Without them, *degrees* too: yaw is beyond 7 rad, and from one tick in a hundred to the next it
/// jumps by more than pi that is no whole turn. O(ticks).
[[nodiscard]] std::optional<ValueFinding> check_yaw(const TickTable& ticks);

}  // namespace tcert
