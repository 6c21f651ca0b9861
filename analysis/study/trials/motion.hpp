#pragma once
/// \file
/// Speed of a logged path, measured over a trailing time so that pose noise does not count as
/// motion.

#include <cstdint>
#include <optional>
#include <span>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert::study {

struct TimedPosition {
  std::int64_t time_ns = 0;  ///< Strictly increasing.
  Point position;
  bool after_break = false;  ///< The path does not continue the position before.
};

struct Motion {
  std::int64_t step_ns = 0;         ///< Since the position before; 0 at a start and after a break.
  std::optional<double> speed_mps;  ///< Empty until the path is `window_ns` old.
};

/// For each position, its distance from the newest one at least `window_ns` older, divided by the
/// time between the two. Starts anew after a break. O(positions). \pre window_ns > 0.
[[nodiscard]] std::vector<Motion> trailing_motion(std::span<const TimedPosition> path,
                                                  std::int64_t window_ns);

}  // namespace tcert::study
