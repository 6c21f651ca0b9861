#include <algorithm>
#include <cmath>
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

Point tip_of(const Pose& pose, const Ray& ray, double clearance_m) noexcept {
  return transform(pose, ray.mount) + clearance_m * direction(pose.yaw_rad + ray.bearing_rad);
}

}  // namespace

double clearance_of(const Ray& ray, double value) noexcept {
  if (!std::isfinite(value)) {
    return kMissing;
  }
  const double clearance_m =
      ray.kind == RayKind::bend ? calibrated_clearance(ray.calibration, value) : value;
  return std::clamp(clearance_m, 0.0, ray.reach_m);
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
      pose =
          between(pose, track.poses[next_pose], elapsed_s(before, now) / elapsed_s(before, after));
    }
    if (!is_usable(pose)) {
      continue;
    }
    samples.poses.push_back(pose);
    samples.breaks.push_back(broken ? 1 : 0);
    broken = false;
    for (std::size_t k = 0; k < samples.rays; ++k) {
      samples.clearances_m.push_back(
          clearance_of(robot.rays[k], touch.values[i * samples.rays + k]));
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
      const double way_m = distance(tip_of(samples.poses[read[j - 1]], robot.rays[k], least_m),
                                    tip_of(samples.poses[read[j + 1]], robot.rays[k], least_m));
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
