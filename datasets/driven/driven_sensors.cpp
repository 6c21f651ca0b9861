#include "datasets/driven/driven_sensors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

#include "datasets/corpus/streams.hpp"
#include "datasets/driven/driven_draws.hpp"

namespace tcert {
namespace {

table::RandomStream clock_of(const DrivenDesign& design, std::uint32_t purpose) {
  return {noise_seed(design), purpose, 2 * design.index};
}

table::RandomStream noise_of(const DrivenDesign& design, std::uint32_t purpose) {
  return {noise_seed(design), purpose, 2 * design.index + 1};
}

std::vector<std::int64_t> times_of(const DrivenDesign& design,
                                   std::uint32_t purpose,
                                   double rate_hz) {
  table::RandomStream random = clock_of(design, purpose);
  return sample_times(rate_hz, design.parameters.time_limit_s, true, random);
}

Pose pose_during(const SensedStep& step, std::int64_t time_ns) noexcept {
  const double share =
      static_cast<double>(time_ns - step.from_ns) / static_cast<double>(step.to_ns - step.from_ns);
  return {step.from.position + share * (step.to.position - step.from.position),
          step.from.yaw_rad + share * angle_between(step.from.yaw_rad, step.to.yaw_rad)};
}

}  // namespace

DrivenSensors::DrivenSensors(const DrivenDesign& design, const WallIndex& walls)
    : parameters_(design.parameters),
      walls_(walls),
      side_(design.mirrored ? -1.0 : 1.0),
      tactile_times_(times_of(design, draws::kDrivenTactile, kTactileRate)),
      pose_times_(times_of(design, draws::kDrivenPose, kPoseRate)),
      tentacles_(design.world.calibration_bias_m,
                 noise_of(design, draws::kDrivenTactile),
                 design.mirrored,
                 design.parameters.noise_scale),
      pose_random_(noise_of(design, draws::kDrivenPose)),
      bump_random_(noise_of(design, draws::kDrivenBumper)),
      speed_random_(noise_of(design, draws::kDrivenSpeed)) {}

void DrivenSensors::sample(const SensedStep& step, TrialLog& log) {
  for (; next_tactile_ < tactile_times_.size() && tactile_times_[next_tactile_] <= step.to_ns;
       ++next_tactile_) {
    const std::int64_t time = tactile_times_[next_tactile_];
    const auto readings =
        tentacles_.read(walls_, pose_during(step, time), step.speed_mps, front_bearing_rad(time));
    log.tactile.time_ns.push_back(time);
    log.tactile.readings.insert(log.tactile.readings.end(), readings.begin(), readings.end());
  }
  for (; next_pose_ < pose_times_.size() && pose_times_[next_pose_] <= step.to_ns; ++next_pose_) {
    const std::int64_t time = pose_times_[next_pose_];
    log.pose.time_ns.push_back(time);
    log.pose.poses.push_back(
        odometry(pose_during(step, time), side_, pose_random_, parameters_.noise_scale));
  }
}

// A sine, so that the joint rests where it turns back.
double DrivenSensors::front_bearing_rad(std::int64_t time_ns) const noexcept {
  if (parameters_.sweep_rad == 0.0) {
    return kMissing;
  }
  const double turns = parameters_.sweep_hz * 1e-9 * static_cast<double>(time_ns);
  const double phase = 2.0 * std::numbers::pi * (turns - std::floor(turns));
  return rounded_to(side_ * parameters_.sweep_rad * elementary::sin(phase), 1e4);
}

void DrivenSensors::feel(const Hold& hold, const Pose& pose) noexcept {
  if (hold.force_n > 0.0 && (!bump_ || hold.force_n > bump_->force_n)) {
    const double azimuth = elementary::atan2(hold.towards.y_m, hold.towards.x_m);
    bump_ = {angle_between(pose.yaw_rad, azimuth), hold.force_n};
  }
}

std::optional<policies::Bump> DrivenSensors::read_bump() noexcept {
  std::optional<policies::Bump> read = bump_;
  bump_.reset();
  if (read) {
    const double scale = parameters_.noise_scale;
    const double off = side_ * scale * parameters_.bump_bearing_sd_rad * bump_random_.normal();
    read->bearing_rad = wrapped_angle(read->bearing_rad + off);
    read->force_n *= elementary::exp(scale * parameters_.bump_log_sd * bump_random_.normal());
  }
  return read;
}

double DrivenSensors::measured_speed_mps(double speed_mps) noexcept {
  return speed_mps + parameters_.noise_scale * parameters_.speed_noise_mps * speed_random_.normal();
}

}  // namespace tcert
