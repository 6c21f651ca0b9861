#pragma once
/// \file
/// What the poses of a CARMEN log are: where the laser is mounted, and whether they are odometry.

#include <cstddef>
#include <optional>
#include <span>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert {

enum class CarmenPoses {
  unknown,    ///< There is no odometry to compare them with.
  corrected,  ///< Another way than that of the odometry.
  odometry,   ///< The odometry itself: not scan-matched.
};

/// Poses of a log in the order of its lines.
struct CarmenTrack {
  std::vector<Pose> laser;                   ///< Of each scan.
  std::vector<Pose> robot;                   ///< Of each scan, as its record has it.
  std::vector<Pose> odometry;                ///< Of each ODOM record that can be read.
  std::vector<std::size_t> odometry_before;  ///< Per scan: how many ODOM records stand before it.
};

/// Where the laser is on the robot: the pose of the first in the frame of the second, if nine of
/// ten scans agree on one, to 5 mm and 5 mrad of the median, that lies within 1 m. Poses that were
/// corrected beside others that were not have no common one; while the robot does not turn they may
/// seem to, so that `turned` asks for half a radian between two scans. Exactly zero below 1 mm and
/// 1 mrad. Empty if there is none. O(n).
[[nodiscard]] std::optional<Pose> laser_mount(const CarmenTrack& track, bool turned);

/// Compares each of the poses with the ODOM records: it is on the way of the odometry if it lies
/// within 5 mm and 5 mrad of a step between two of the last five records before it, or of the step
/// to the next one. Most on the way: odometry. A pose that equals the next record to the last digit
/// and not the one before is none: programs that correct poses write it there once more.
/// (Of thirteen corrected public logs at most 10 % of the scans are on the way; raw logs
/// interpolate between records, so nearly all are.) \pre a pose per scan of the track. O(n).
[[nodiscard]] CarmenPoses origin_of(std::span<const Pose> poses, const CarmenTrack& track);

/// `local`, given in the frame of `pose`, in the frame that `pose` is given in.
[[nodiscard]] Pose compose(const Pose& pose, const Pose& local) noexcept;

/// `pose` as it is seen from `frame`: compose(frame, seen_from(frame, pose)) is `pose`.
[[nodiscard]] Pose seen_from(const Pose& frame, const Pose& pose) noexcept;

}  // namespace tcert
