#include "datasets/random_worlds/random_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>
#include <tcert/geometry.hpp>

#include "datasets/corpus/streams.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {
namespace {

constexpr std::uint32_t kStray = 0x7277'0101;
constexpr std::uint32_t kBias = 0x7277'0102;
constexpr double kLeastFree = 0.0005;  // between body and wall, at least
constexpr double kWayBack = 0.4;
constexpr double kFadeIn = 0.5;  // way on which the waves grow, and fade before a leg's end
constexpr double kBiasSd = 0.004;
constexpr double kTouchForce = 1.0;
constexpr int kStandBefore = 6;  // steps
constexpr int kStandAfter = 12;
constexpr int kStepsPerTick = 2;

/// Lateral waves of unit amplitude.
struct Waves {
  std::array<double, 2> per_metre{};
  std::array<double, 2> phase{};
  [[nodiscard]] double at(double along) const noexcept {
    return 0.6 * elementary::sin(per_metre[0] * along + phase[0]) +
           0.4 * elementary::sin(per_metre[1] * along + phase[1]);
  }
};

Waves draw_waves(table::RandomStream& random) {
  Waves waves;
  for (std::size_t k = 0; k < waves.phase.size(); ++k) {
    waves.per_metre[k] = 2.0 * std::numbers::pi / random.uniform(0.8, 2.0);
    waves.phase[k] = random.uniform(0.0, 2.0 * std::numbers::pi);
  }
  return waves;
}

/// A leg's path as it is driven: points with the way to each, and headings of motion.
struct Track {
  std::vector<Point> points;
  std::vector<double> along;
  std::vector<double> heading;
};

std::vector<double> way_to(const std::vector<Point>& points) {
  std::vector<double> along(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    along[i] = along[i - 1] + distance(points[i - 1], points[i]);
  }
  return along;
}

/// Heading at each point, from its neighbours two on either side.
std::vector<double> headings_of(const std::vector<Point>& points) {
  constexpr std::size_t kSpan = 2;
  std::vector<double> headings(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point way =
        points[std::min(i + kSpan, points.size() - 1)] - points[i - std::min(i, kSpan)];
    headings[i] = elementary::atan2(way.y_m, way.x_m);
  }
  return headings;
}

Track strayed(const std::vector<Point>& path, const Waves& waves, double wobble) {
  Track track;
  track.points = path;
  const std::vector<double> along = way_to(path);
  const std::vector<double> heading = headings_of(path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double edge = std::min(along[i], along.back() - along[i]);
    const double x = std::clamp(edge / kFadeIn, 0.0, 1.0);
    const double off = wobble * x * x * (3.0 - 2.0 * x) * waves.at(along[i]);
    const Point u = direction(heading[i]);
    track.points[i] = path[i] + off * Point{-u.y_m, u.x_m};
  }
  track.along = way_to(track.points);
  track.heading = headings_of(track.points);
  return track;
}

Pose pose_on(const Track& track, double at, std::size_t& segment) noexcept {
  while (segment + 2 < track.points.size() && track.along[segment + 1] < at) {
    ++segment;
  }
  const double length = track.along[segment + 1] - track.along[segment];
  const double share =
      length > 0.0 ? std::clamp((at - track.along[segment]) / length, 0.0, 1.0) : 0.0;
  const Point step = track.points[segment + 1] - track.points[segment];
  return {track.points[segment] + share * step,
          track.heading[segment] +
              share * angle_between(track.heading[segment], track.heading[segment + 1])};
}

class Follower {
 public:
  Follower(const WallIndex& walls, double speed_mps)
      : walls_(walls), step_m_(speed_mps * kDriveStep) {}

  void stand(int steps) {
    for (int i = 0; i < steps; ++i) {
      record(drive_.poses.back(), 0.0);
    }
  }

  /// False if the body does not fit; it then stands at the last place where it does.
  bool follow(const Track& track, bool reverse) {
    std::size_t segment = 0;
    const double end = track.along.back();
    double at = 0.0;
    while (at < end) {
      Pose pose = pose_on(track, at, segment);
      if (walls_.distance_from(pose.position) < 0.5 * corpus_robot().body_width_m + kLeastFree) {
        return false;
      }
      pose.yaw_rad = wrapped_angle(pose.yaw_rad + (reverse ? std::numbers::pi : 0.0));
      const double travelled = drive_.poses.empty() ? 0.0 : step_m_;
      record(pose, reverse ? -travelled : travelled);
      drive_.distance_m += travelled;
      at += step_m_;
    }
    return true;
  }

  void back_off() {
    const auto steps = static_cast<std::size_t>(kWayBack / step_m_);
    const std::size_t stuck = drive_.poses.size();
    for (std::size_t i = 1; i <= steps && i < stuck; ++i) {
      record(drive_.poses[stuck - 1 - i], -step_m_);
    }
  }

  [[nodiscard]] bool empty() const noexcept { return drive_.poses.empty(); }

  Drive take(EndReason reason) {
    drive_.end_reason = reason;
    drive_.time_s = kDriveStep * static_cast<double>(drive_.poses.size());
    return std::move(drive_);
  }

 private:
  void record(Pose pose, double travelled) {
    drive_.poses.push_back(pose);
    drive_.speed_cmd_mps.push_back(travelled / kDriveStep);
    drive_.yaw_rate_cmd_rps.push_back(0.0);
  }

  const WallIndex& walls_;
  double step_m_;
  Drive drive_;
};

void append_true_readings(const WallIndex& walls,
                          const Pose& pose,
                          std::vector<RayReading>& readings) {
  const auto clearances = cast_tentacles(walls, pose);
  for (std::size_t k = 0; k < kTentacles; ++k) {
    const Ray& ray = corpus_robot().rays[k];
    readings.push_back({calibrated_bend(ray.calibration, clearances[k]),
                        clearances[k] < ray.reach_m ? kTouchForce : 0.0});
  }
}

StreamOptions noisy(std::uint64_t seed, std::uint64_t index) {
  StreamOptions options;
  options.seed = seed;
  options.index = index;
  options.calibration_bias_m = kBiasSd * table::RandomStream(seed, kBias, index).normal();
  return options;
}

TrialLog true_log(const Drive& drive, const WallIndex& walls) {
  constexpr std::int64_t kPoseStep = 50'000'000;
  constexpr std::int64_t kTouchStep = 12'048'193;  // 83 Hz
  TrialLog log;
  for (std::size_t i = 0; i < drive.poses.size(); ++i) {
    log.pose.time_ns.push_back(static_cast<std::int64_t>(i) * kPoseStep);
    log.pose.poses.push_back(drive.poses[i]);
  }
  log.tactile.rays = kTentacles;
  const std::int64_t end = log.pose.time_ns.empty() ? -1 : log.pose.time_ns.back();
  for (std::int64_t time = 0; time <= end; time += kTouchStep) {
    log.tactile.time_ns.push_back(time);
    append_true_readings(walls, pose_at(drive, time), log.tactile.readings);
  }
  return log;
}

}  // namespace

WallIndex feelable_walls(const RandomWorld& drawn) {
  if (drawn.edge_walls.empty()) {
    return {drawn.world, kSensingRange};
  }
  World walled = drawn.world;
  walled.obstacles.insert(walled.obstacles.end(), drawn.edge_walls.begin(), drawn.edge_walls.end());
  return {walled, kSensingRange};
}

Drive follow_legs(const RandomWorld& drawn,
                  const WallIndex& walls,
                  std::uint64_t seed,
                  std::uint64_t index) {
  table::RandomStream random(seed, kStray, index);
  std::vector<Waves> waves;
  for (std::size_t i = 0; i < drawn.legs.size(); ++i) {
    waves.push_back(draw_waves(random));
  }
  for (const double share : {1.0, 0.25, 0.0}) {
    Follower follower(walls, drawn.speed_mps);
    bool fits = true;
    for (std::size_t i = 0; i < drawn.legs.size() && fits; ++i) {
      fits = follower.follow(strayed(drawn.legs[i].path, waves[i], share * drawn.wobble_m),
                             drawn.legs[i].reverse);
    }
    if (fits) {
      follower.stand(kStandAfter);
      return follower.take(EndReason::goal);
    }
    if (share == 0.0 && !follower.empty()) {
      follower.back_off();
      follower.stand(kStandBefore);
      return follower.take(EndReason::wedged);
    }
  }
  return {};
}

TickTable true_ticks(const Drive& drive, const WallIndex& walls) {
  TickTable ticks;
  ticks.rays = kTentacles;
  for (std::size_t i = 0; i < drive.poses.size(); i += kStepsPerTick) {
    ticks.time_ns.push_back(static_cast<std::int64_t>(i) * 50'000'000);
    ticks.poses.push_back(drive.poses[i]);
    append_true_readings(walls, drive.poses[i], ticks.readings);
    ticks.speed_cmd_mps.push_back(drive.speed_cmd_mps[i]);
    ticks.yaw_rate_cmd_rps.push_back(drive.yaw_rate_cmd_rps[i]);
  }
  ticks.stale.assign(ticks.size(), 0);
  ticks.segment_start.assign(ticks.size(), 0);
  return ticks;
}

TickTable logged_ticks(const Drive& drive,
                       const WallIndex& walls,
                       std::uint64_t seed,
                       std::uint64_t index) {
  return resample(log_drive(drive, walls, noisy(seed, index)));
}

TrialLog native_log(const Drive& drive,
                    const WallIndex& walls,
                    bool noise,
                    std::uint64_t seed,
                    std::uint64_t index) {
  if (!noise) {
    return true_log(drive, walls);
  }
  StreamOptions options = noisy(seed, index);
  options.native_rates = true;
  return log_drive(drive, walls, options);
}

}  // namespace tcert
