#pragma once
/// \file
/// What the robot felt at one instant of the 10 Hz grid (paper 3.1).

#include <cstdint>
#include <limits>
#include <span>
#include <tcert/geometry.hpp>

namespace tcert {

inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// The largest coordinate in m and yaw in rad of a pose: no lengths then overflow.
inline constexpr double kLargestPose = 1e9;

/// Seconds from one time stamp to another, whatever the two are.
[[nodiscard]] constexpr double elapsed_s(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  const auto from = static_cast<std::uint64_t>(from_ns);
  const auto to = static_cast<std::uint64_t>(to_ns);
  return to_ns >= from_ns ? 1e-9 * static_cast<double>(to - from)
                          : -1e-9 * static_cast<double>(from - to);
}

/// Reading of one ray: filtered (median of three raw samples), not calibrated.
struct RayReading {
  double value = kMissing;  ///< Bend in rad or range in m, by the ray's kind; NaN is missing.
  double fsr_n = kMissing;  ///< Tip force in N; NaN if the ray has no force sensor.
  /// Where a ray that a joint moves pointed, from the heading; NaN: along the ray's own bearing.
  double bearing_rad = kMissing;
};

/// What is underfoot; NaN is not measured at this tick.
struct Footing {
  double pitch_rad = kMissing;
  double roll_rad = kMissing;
  double step_m = kMissing;  ///< Height of a step up or down.
  double slip = kMissing;    ///< Share of the commanded way that the robot did not move.
};

/// One tick. `rays` holds one reading per ray of the robot, in its order, and is only looked at
/// during the call that takes the tick.
struct Tick {
  std::int64_t time_ns = 0;  ///< On the trial's monotonic clock; strictly increasing.
  Pose pose;                 ///< Each number at most kLargestPose in size, or it is bad input.
  std::span<const RayReading> rays;
  bool stale = false;          ///< A required stream is silent: no evidence.
  bool segment_start = false;  ///< The log has a gap before this tick: the path is broken here.
  Footing footing{};
};

}  // namespace tcert
