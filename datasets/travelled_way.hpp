#pragma once
/// \file
/// How far the robot of a table of ticks has come.

#include <vector>

#include "datasets/ticks.hpp"

namespace tcert {

/// Metres up to each tick, from 0: the sum of the steps of at least 1 cm, since shorter ones are
/// pose noise. A step into a tick that starts a segment does not count.
[[nodiscard]] std::vector<double> travelled_way(const TickTable& ticks);

}  // namespace tcert
