#include "datasets/corpus/streams.hpp"

#include <algorithm>
#include <cmath>
#include <tcert/elementary.hpp>

#include "datasets/corpus/purpose.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr double kPoseNoise = 0.0008;
constexpr double kYawNoise = 0.002;
constexpr double kJitter = 0.1;                  // of a period, uniform to either side
constexpr double kLostShare = 0.001;             // single samples that never arrive
constexpr double kDropoutRate = 0.004;           // longer silences per second of a native stream
constexpr double kLatency = 19.6;                // ms, median
constexpr double kLatencySpread = 0.25;          // ms, scale of its jitter
constexpr std::int64_t kClockQuantum = 100'000;  // ns

double speed_at(const Drive& drive, std::int64_t time_ns) {
  const auto i =
      std::min(static_cast<std::size_t>(static_cast<double>(time_ns) * 1e-9 / kDriveStep) + 1,
               drive.poses.size() - 1);
  return distance(drive.poses[i - 1].position, drive.poses[i].position) / kDriveStep;
}

PoseStream log_pose(const Drive& drive, double end_s, const StreamOptions& options) {
  table::RandomStream clock(options.seed, draws::kPose, 2 * options.index);
  table::RandomStream random(options.seed, draws::kPose, 2 * options.index + 1);
  PoseStream stream;
  stream.time_ns = sample_times(kPoseRate, end_s, options.native_rates, clock);
  stream.poses.reserve(stream.time_ns.size());
  for (const std::int64_t time : stream.time_ns) {
    stream.poses.push_back(odometry(pose_at(drive, time), 1.0, random));
  }
  return stream;
}

TactileStream log_tactile(const Drive& drive,
                          const WallIndex& walls,
                          double end_s,
                          const StreamOptions& options) {
  table::RandomStream clock(options.seed, draws::kTactile, 2 * options.index);
  TentacleSensors sensors(
      options.calibration_bias_m,
      table::RandomStream(options.seed, draws::kTactile, 2 * options.index + 1));
  TactileStream stream;
  stream.rays = kTentacles;
  stream.time_ns =
      sample_times(options.native_rates ? kTactileRate : 20.0, end_s, options.native_rates, clock);
  stream.readings.reserve(stream.time_ns.size() * kTentacles);
  for (const std::int64_t time : stream.time_ns) {
    const auto readings = sensors.read(walls, pose_at(drive, time), speed_at(drive, time));
    stream.readings.insert(stream.readings.end(), readings.begin(), readings.end());
  }
  return stream;
}

ControlStream log_control(const Drive& drive, double end_s, const StreamOptions& options) {
  table::RandomStream clock(options.seed, draws::kControl, 2 * options.index);
  table::RandomStream random(options.seed, draws::kControl, 2 * options.index + 1);
  ControlStream stream;
  stream.time_ns =
      sample_times(options.native_rates ? 50.0 : 20.0, end_s, options.native_rates, clock);
  for (const std::int64_t time : stream.time_ns) {
    const auto at = static_cast<std::size_t>(static_cast<double>(time) * 1e-9 / kDriveStep);
    const std::size_t i = std::min(at, drive.poses.size() - 1);
    stream.speed_cmd_mps.push_back(rounded_to(drive.speed_cmd_mps[i], 1e4));
    stream.yaw_rate_cmd_rps.push_back(rounded_to(drive.yaw_rate_cmd_rps[i], 1e4));
    stream.loop_latency_ms.push_back(draw_latency_ms(kLatency, kLatencySpread, random));
  }
  return stream;
}

}  // namespace

std::vector<std::int64_t> sample_times(double rate_hz,
                                       double end_s,
                                       bool native_rates,
                                       table::RandomStream& random) {
  std::vector<std::int64_t> times;
  const double period = 1.0 / rate_hz;
  times.reserve(static_cast<std::size_t>(end_s * rate_hz) + 1);
  double silent_until = -1.0;
  for (std::int64_t i = 0;; ++i) {
    const double t = period * (static_cast<double>(i) + 0.5 + random.uniform(-kJitter, kJitter));
    if (t >= end_s) {
      return times;
    }
    if (native_rates && random.uniform() < kDropoutRate * period) {
      silent_until = t + random.uniform(0.2, 0.7);
    }
    const bool lost = random.uniform() < kLostShare || t < silent_until;
    if (i == 0 || !lost) {
      times.push_back(std::llround(t * 1e9 / static_cast<double>(kClockQuantum)) * kClockQuantum);
    }
  }
}

Pose odometry(const Pose& pose, double side, table::RandomStream& random, double scale) noexcept {
  const double yaw = pose.yaw_rad + side * (scale * kYawNoise * random.normal());
  const double x = pose.position.x_m + scale * kPoseNoise * random.normal();
  const double y = pose.position.y_m + side * (scale * kPoseNoise * random.normal());
  return {{rounded_to(x, 1e4), rounded_to(y, 1e4)}, rounded_to(wrapped_angle(yaw), 1e4)};
}

double draw_latency_ms(double median_ms, double scale_ms, table::RandomStream& random) noexcept {
  const double u = random.uniform() - 0.5;
  const double jitter = -std::copysign(elementary::log(1.0 - 2.0 * std::abs(u)), u);
  return rounded_to(median_ms + scale_ms * jitter, 1e2);
}

Pose pose_at(const Drive& drive, std::int64_t time_ns) noexcept {
  const double at = static_cast<double>(time_ns) * 1e-9 / kDriveStep;
  const auto i = std::min(static_cast<std::size_t>(at), drive.poses.size() - 1);
  const auto j = std::min(i + 1, drive.poses.size() - 1);
  const double share = std::clamp(at - static_cast<double>(i), 0.0, 1.0);
  const Pose& a = drive.poses[i];
  const Pose& b = drive.poses[j];
  return {a.position + share * (b.position - a.position),
          a.yaw_rad + share * angle_between(a.yaw_rad, b.yaw_rad)};
}

TrialLog log_drive(const Drive& drive, const WallIndex& walls, const StreamOptions& options) {
  const double end_s = kDriveStep * static_cast<double>(drive.poses.size());
  TrialLog log;
  log.pose = log_pose(drive, end_s, options);
  log.tactile = log_tactile(drive, walls, end_s, options);
  log.control = log_control(drive, end_s, options);
  return log;
}

}  // namespace tcert
