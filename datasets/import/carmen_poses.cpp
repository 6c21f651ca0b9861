#include "datasets/import/carmen_poses.hpp"

#include <algorithm>
#include <cmath>

namespace tcert {
namespace {

constexpr double kMountSpreadMetres = 0.005;
constexpr double kMountSpreadRadians = 0.005;
constexpr double kFurthestMountMetres = 1.0;
constexpr double kNoMountMetres = 0.001;
constexpr double kNoMountRadians = 0.001;
constexpr double kLeastTurnRadians = 0.5;
constexpr double kOnTheWayMetres = 0.005;
constexpr double kOnTheWayRadians = 0.005;
constexpr std::size_t kRecordsBefore = 5;

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool are_near(const Pose& a, const Pose& b, double within_m, double within_rad) noexcept {
  return distance(a.position, b.position) <= within_m &&
         std::abs(angle_between(a.yaw_rad, b.yaw_rad)) <= within_rad;
}

bool has_turned(std::span<const Pose> poses) noexcept {
  return std::ranges::any_of(poses, [&](const Pose& pose) {
    return std::abs(angle_between(poses.front().yaw_rad, pose.yaw_rad)) >= kLeastTurnRadians;
  });
}

/// True if the pose is one that a step from `from` to `to` has on its way.
bool is_on_step(const Pose& pose, const Pose& from, const Pose& to) noexcept {
  const Point step = to.position - from.position;
  const double turn = angle_between(from.yaw_rad, to.yaw_rad);
  const double length = dot(step, step);
  double share = 0.0;
  if (length > 0.0) {
    share = dot(pose.position - from.position, step) / length;
  } else if (turn != 0.0) {
    share = angle_between(from.yaw_rad, pose.yaw_rad) / turn;
  }
  share = std::clamp(share, 0.0, 1.0);
  const Pose nearest{from.position + share * step, from.yaw_rad + share * turn};
  return are_near(pose, nearest, kOnTheWayMetres, kOnTheWayRadians);
}

bool are_equal(const Pose& a, const Pose& b) noexcept {
  return a.position == b.position && a.yaw_rad == b.yaw_rad;
}

/// \pre there is a record before the pose.
bool is_on_way(const Pose& pose, std::span<const Pose> odometry, std::size_t before) noexcept {
  const std::size_t first = before > kRecordsBefore ? before - kRecordsBefore : 0;
  for (std::size_t i = first; i < before; ++i) {
    if (is_on_step(pose, odometry[i], odometry[std::min(i + 1, before - 1)])) {
      return true;
    }
  }
  return before < odometry.size() && !are_equal(pose, odometry[before]) &&
         is_on_step(pose, odometry[before - 1], odometry[before]);
}

}  // namespace

Pose compose(const Pose& pose, const Pose& local) noexcept {
  return {transform(pose, local.position), pose.yaw_rad + local.yaw_rad};
}

Pose seen_from(const Pose& frame, const Pose& pose) noexcept {
  const Point u = direction(frame.yaw_rad);
  const Point offset = pose.position - frame.position;
  return {{dot(u, offset), cross(u, offset)}, angle_between(frame.yaw_rad, pose.yaw_rad)};
}

std::optional<Pose> laser_mount(const CarmenTrack& track, bool turned) {
  const std::size_t scans = track.laser.size();
  if (scans == 0 || (turned && !has_turned(track.laser))) {
    return std::nullopt;
  }
  std::vector<Pose> mounts(scans);
  std::vector<double> x(scans);
  std::vector<double> y(scans);
  std::vector<double> yaw(scans);
  for (std::size_t i = 0; i < scans; ++i) {
    mounts[i] = seen_from(track.robot[i], track.laser[i]);
    x[i] = mounts[i].position.x_m;
    y[i] = mounts[i].position.y_m;
    yaw[i] = mounts[i].yaw_rad;
  }
  const Pose middle{{middle_of(std::move(x)), middle_of(std::move(y))}, middle_of(std::move(yaw))};
  const auto agree = std::ranges::count_if(mounts, [&](const Pose& mount) {
    return are_near(mount, middle, kMountSpreadMetres, kMountSpreadRadians);
  });
  if (10 * static_cast<std::size_t>(agree) < 9 * scans ||
      norm(middle.position) > kFurthestMountMetres) {
    return std::nullopt;
  }
  return are_near(middle, {}, kNoMountMetres, kNoMountRadians) ? Pose{} : middle;
}

CarmenPoses origin_of(std::span<const Pose> poses, const CarmenTrack& track) {
  std::size_t compared = 0;
  std::size_t on_way = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (track.odometry_before[i] > 0) {
      ++compared;
      on_way += is_on_way(poses[i], track.odometry, track.odometry_before[i]) ? 1 : 0;
    }
  }
  if (compared == 0) {
    return CarmenPoses::unknown;
  }
  return 2 * on_way > compared ? CarmenPoses::odometry : CarmenPoses::corrected;
}

}  // namespace tcert
