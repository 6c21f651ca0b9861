#pragma once
/// \file
/// A robot that laps a circle, so that a corridor graph of any size is walked again and again.

#include <cstddef>
#include <tcert/robot.hpp>
#include <vector>

namespace tcert::test_support {

struct Lap {
  Robot robot;  ///< Range rays to the left, to the right and ahead.
  Course course;
  std::vector<Pose> poses;  ///< One lap, 17 mm a tick: 0.17 m/s at 10 Hz.
};

/// A circle of about `nodes` edges of 0.25 m. S lies where it begins, G opposite.
[[nodiscard]] Lap make_lap(std::size_t nodes);

}  // namespace tcert::test_support
