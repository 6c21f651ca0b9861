#include <algorithm>
#include <cmath>
#include <tcert/felt_clearance.hpp>
#include <tcert/tick.hpp>
#include <witness/samples.hpp>

namespace tcert::witness {
namespace {

constexpr double kGlitch = 0.006;  // m, beyond which a reading is not noise

Pose between(const Pose& a, const Pose& b, double share) noexcept {
  return {a.position + share * (b.position - a.position),
          a.yaw_rad + share * angle_between(a.yaw_rad, b.yaw_rad)};
}

bool is_usable(const Pose& pose) noexcept {
  return std::abs(pose.position.x_m) <= kLargestPose &&
         std::abs(pose.position.y_m) <= kLargestPose && std::abs(pose.yaw_rad) <= kLargestPose;
}

/// Of ray `k` at sample `i`, were its clearance `clearance_m`.
Point tip_of(const Samples& samples,
             const Robot& robot,
             std::size_t i,
             std::size_t k,
             double clearance_m) noexcept {
  return transform(samples.poses[i], robot.rays[k].mount) +
         clearance_m * samples.direction_of(robot, i, k);
}

bool moves(std::span<const RayReading> readings) noexcept {
  return std::ranges::any_of(
      readings, [](const RayReading& reading) { return !std::isnan(reading.bearing_rad); });
}

}  // namespace

Point Samples::direction_of(const Robot& robot, std::size_t i, std::size_t k) const noexcept {
  const double bearing_rad =
      bearings_rad.empty() ? robot.rays[k].bearing_rad : bearings_rad[i * rays + k];
  return direction(poses[i].yaw_rad + bearing_rad);
}

bool add_sample(Samples& samples,
                const Robot& robot,
                const Pose& pose,
                std::span<const RayReading> readings,
                bool is_after_break,
                std::int64_t known_ns) {
  if (!is_usable(pose)) {
    return false;
  }
  samples.rays = robot.rays.size();
  const bool has_joint = !samples.bearings_rad.empty() || moves(readings);
  while (has_joint && samples.bearings_rad.size() < samples.clearances_m.size()) {
    samples.bearings_rad.push_back(  // no joint had been heard of
        robot.rays[samples.bearings_rad.size() % samples.rays].bearing_rad);
  }
  for (std::size_t k = 0; k < samples.rays; ++k) {
    samples.clearances_m.push_back(felt_clearance(robot.rays[k], readings[k]));
    if (has_joint) {
      samples.bearings_rad.push_back(bearing_of(robot.rays[k], readings[k].bearing_rad));
    }
  }
  samples.poses.push_back(pose);
  samples.breaks.push_back(is_after_break ? 1 : 0);
  samples.known_ns.push_back(known_ns);
  return true;
}

Samples at_touch_times(const Robot& robot,
                       const PoseTrack& track,
                       const TouchTrack& touch,
                       std::span<const std::int64_t> breaks_ns,
                       double bridge_s) {
  Samples samples;
  samples.rays = robot.rays.size();
  std::size_t next_pose = 0;  // the first after the touch
  std::size_t next_break = 0;
  bool broken = true;
  for (std::size_t i = 0; i < touch.time_ns.size(); ++i) {
    const std::int64_t now = touch.time_ns[i];
    while (next_pose < track.time_ns.size() && track.time_ns[next_pose] <= now) {
      ++next_pose;
    }
    while (next_break < breaks_ns.size() && breaks_ns[next_break] <= now) {
      ++next_break;
      broken = true;
    }
    if (next_pose == 0) {
      continue;
    }
    const std::int64_t before = track.time_ns[next_pose - 1];
    Pose pose = track.poses[next_pose - 1];
    std::int64_t known_ns = now;
    if (before != now) {
      const bool broke_within = next_break > 0 && breaks_ns[next_break - 1] > before;
      if (next_pose == track.time_ns.size() || broke_within) {
        continue;
      }
      const std::int64_t after = track.time_ns[next_pose];
      const bool breaks_soon = next_break < breaks_ns.size() && breaks_ns[next_break] <= after;
      if (breaks_soon || elapsed_s(before, after) > bridge_s) {
        continue;
      }
      known_ns = after;
      pose =
          between(pose, track.poses[next_pose], elapsed_s(before, now) / elapsed_s(before, after));
    }
    const auto readings = touch.readings.subspan(i * samples.rays, samples.rays);
    if (add_sample(samples, robot, pose, readings, broken, known_ns)) {
      broken = false;
    }
  }
  return samples;
}

void drop_glitches(Samples& samples, const Robot& robot, double lost_share) {
  for (std::size_t k = 0; k < samples.rays; ++k) {
    std::vector<std::size_t> read;  // samples with a reading of this ray
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!std::isnan(samples.clearances_m[i * samples.rays + k])) {
        read.push_back(i);
      }
    }
    std::vector<std::size_t> dropped;
    for (std::size_t j = 1; j + 1 < read.size(); ++j) {
      const auto reading = [&](std::size_t at) {
        return samples.clearances_m[read[at] * samples.rays + k];
      };
      const double least_m = std::min(reading(j - 1), reading(j + 1));
      const double way_m = distance(tip_of(samples, robot, read[j - 1], k, least_m),
                                    tip_of(samples, robot, read[j + 1], k, least_m));
      if (reading(j) < least_m - lost_share * way_m - kGlitch) {
        dropped.push_back(read[j]);
      }
    }
    for (const std::size_t i : dropped) {
      samples.clearances_m[i * samples.rays + k] = kMissing;
    }
  }
}

}  // namespace tcert::witness
