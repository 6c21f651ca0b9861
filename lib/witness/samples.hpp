#pragma once
/// \file
/// Where the rays of one run were felt, at the rate at which they were felt.

#include <cstddef>
#include <cstdint>
#include <span>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert::witness {

/// Instants at which there is a pose and a reading. `clearances_m` is row-major, samples x rays of
/// the robot, in metres from each ray's mount; NaN where a ray has no reading.
struct Samples {
  std::size_t rays = 0;
  std::vector<Pose> poses;
  std::vector<double> clearances_m;
  /// The bearings of the readings, likewise; empty if no joint moves a ray.
  std::vector<double> bearings_rad;
  /// 1 where the path broke before the sample: no ray sweeps from the one before to this one.
  std::vector<std::uint8_t> breaks;
  /// When both pose and reading were there: of an interpolated pose at that after it. They rise.
  std::vector<std::int64_t> known_ns;

  [[nodiscard]] std::size_t size() const noexcept { return poses.size(); }
  /// Unit vector of ray `k` of `robot` at sample `i`.
  [[nodiscard]] Point direction_of(const Robot& robot, std::size_t i, std::size_t k) const noexcept;
};

/// Adds one, with a reading a ray; false if its pose cannot be used. O(rays).
bool add_sample(Samples& samples,
                const Robot& robot,
                const Pose& pose,
                std::span<const RayReading> readings,
                bool is_after_break,
                std::int64_t known_ns);

/// Poses of a stream; the times, in ns, rise strictly.
struct PoseTrack {
  std::span<const std::int64_t> time_ns;
  std::span<const Pose> poses;
};

/// Readings of a stream, row-major, times x rays of the robot; the times, in ns, rise strictly.
struct TouchTrack {
  std::span<const std::int64_t> time_ns;
  std::span<const RayReading> readings;
};

/// One sample at each time of `touch` at which the pose is known: that of a pose sample, or between
/// two that are at most `bridge_s` seconds apart, by linear interpolation. A touch without a pose
/// is left out. The first sample at or after each of `breaks_ns`, which rise, is marked; no pose is
/// interpolated across one. O(touches + poses).
[[nodiscard]] Samples at_touch_times(const Robot& robot,
                                     const PoseTrack& track,
                                     const TouchTrack& touch,
                                     std::span<const std::int64_t> breaks_ns,
                                     double bridge_s);

/// Takes out readings that both neighbours of their ray contradict: lower than the lesser of the
/// two by more than what an obstacle can reach in between them (`lost_share` of the way of the
/// ray's tip) and 6 mm. A reading that is left out proves nothing, so this can only lose.
void drop_glitches(Samples& samples, const Robot& robot, double lost_share);

}  // namespace tcert::witness
