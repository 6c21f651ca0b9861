#include "datasets/driven/driven_sensors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

#include "datasets/corpus/streams.hpp"
#include "datasets/driven/driven_draws.hpp"

namespace tcert {
namespace {

// Standard deviations of what is felt underfoot.
constexpr double kTiltNoise = 0.01;   // rad
constexpr double kStepNoise = 0.005;  // m
constexpr double kSlipNoise = 0.02;

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
      speed_random_(noise_of(design, draws::kDrivenSpeed)),
      footing_random_(noise_of(design, draws::kDrivenFooting)),
      relief_(design.world.relief) {}

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
    const Pose pose = pose_during(step, time);
    log.pose.time_ns.push_back(time);
    log.pose.poses.push_back(odometry(pose, side_, pose_random_, parameters_.noise_scale));
    if (!relief_.empty()) {
      log_footing(pose, step.slip, log.pose);
    }
  }
}

void DrivenSensors::log_footing(const Pose& pose, double slip, PoseStream& log) {
  const double scale = parameters_.noise_scale;
  Footing footing = footing_at(relief_, pose);
  footing.pitch_rad += scale * kTiltNoise * footing_random_.normal();
  footing.roll_rad += side_ * scale * kTiltNoise * footing_random_.normal();
  footing.step_m = std::max(footing.step_m + scale * kStepNoise * footing_random_.normal(), 0.0);
  footing.slip = std::isnan(slip)
                     ? slip
                     : std::clamp(slip + scale * kSlipNoise * footing_random_.normal(), 0.0, 1.0);
  log.footing.push_back({rounded_to(footing.pitch_rad, 1e4),
                         rounded_to(footing.roll_rad, 1e4),
                         rounded_to(footing.step_m, 1e4),
                         rounded_to(footing.slip, 1e4)});
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
