#include "datasets/corpus/tentacles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>
#include <utility>

namespace tcert {
namespace {

constexpr double kReach = 0.45;
constexpr double kGlitchShare = 0.005;
constexpr double kHysteresis = 0.004;
constexpr double kShortestWave = 0.06;
constexpr double kLongestWave = 0.20;
constexpr double kWhiteNoise = 0.0015;
constexpr double kLeastForce = 0.58;
constexpr double kForcePerSpeed = 9.0;
constexpr double kSlowest = 0.04;  // m/s, below which a rubbing tip's force would not fall further
constexpr double kForceNoise = 0.03;

Ray tentacle(const char* name, Point mount, double bearing) {
  return {name,
          mount,
          bearing,
          kReach,
          RayKind::bend,
          {{0.0, 0.15, 0.35, 0.6, 0.9, 1.2}, {kReach, 0.40, 0.32, 0.22, 0.10, 0.0}}};
}

Robot make_robot() {
  Robot robot;
  robot.body_width_m = 0.45;
  robot.min_turn_radius_m = 0.35;
  robot.rays = {tentacle("left", {0.16, 0.12}, 0.5 * std::numbers::pi),
                tentacle("right", {0.16, -0.12}, -0.5 * std::numbers::pi),
                tentacle("front", {0.22, 0.0}, 0.0)};
  return robot;
}

/// Least bend per metre of clearance: |d bend / d clearance| of the calibration at a clearance.
double bend_per_metre(const Calibration& calibration, double clearance) {
  std::size_t knot = 1;
  while (knot + 1 < calibration.clearance_m.size() && calibration.clearance_m[knot] > clearance) {
    ++knot;
  }
  return (calibration.bend_rad[knot] - calibration.bend_rad[knot - 1]) /
         (calibration.clearance_m[knot - 1] - calibration.clearance_m[knot]);
}

}  // namespace

// Adding 0 turns -0 into 0.
double rounded_to(double value, double scale) noexcept {
  return std::round(value * scale) / scale + 0.0;
}

const Robot& corpus_robot() {
  static const Robot robot = make_robot();
  return robot;
}

std::array<double, kTentacles> cast_tentacles(const WallIndex& walls,
                                              const Pose& pose,
                                              double front_rad) noexcept {
  const Robot& robot = corpus_robot();
  const Point u = direction(pose.yaw_rad);
  std::array<double, kTentacles> clearances{};
  for (std::size_t k = 0; k < kTentacles; ++k) {
    const Ray& ray = robot.rays[k];
    const Point mount = pose.position + Point{u.x_m * ray.mount.x_m - u.y_m * ray.mount.y_m,
                                              u.y_m * ray.mount.x_m + u.x_m * ray.mount.y_m};
    const double bearing_rad = bearing_of(ray, k == kFront ? front_rad : kMissing);
    clearances[k] =
        walls.cast(pose.position, mount, direction(pose.yaw_rad + bearing_rad), ray.reach_m);
  }
  return clearances;
}

TentacleSensors::TentacleSensors(double calibration_bias_m,
                                 table::RandomStream random,
                                 bool mirrored,
                                 double noise_scale)
    : calibration_bias_m_(noise_scale * calibration_bias_m),
      noise_scale_(noise_scale),
      random_(random),
      order_{0, 1, 2} {
  if (mirrored) {
    std::swap(order_[0], order_[1]);
  }
  for (const std::size_t k : order_) {
    noise_m_[k] = random_.uniform(0.005, 0.008);
  }
  for (const std::size_t k : order_) {
    for (Wave& wave : texture_[k]) {
      const double length = random_.uniform(kShortestWave, kLongestWave);
      wave = {2.0 * std::numbers::pi / length, random_.uniform(0.0, 2.0 * std::numbers::pi)};
    }
  }
}

double TentacleSensors::texture(std::size_t tentacle) const noexcept {
  double sum = 0.0;
  for (const Wave& wave : texture_[tentacle]) {
    sum += elementary::sin(wave.per_metre * travelled_m_ + wave.phase);
  }
  return sum * std::sqrt(2.0 / static_cast<double>(kWaves));
}

std::array<RayReading, kTentacles> TentacleSensors::read(const WallIndex& walls,
                                                         const Pose& pose,
                                                         double speed_mps,
                                                         double front_rad) noexcept {
  const Robot& robot = corpus_robot();
  const auto clearances = cast_tentacles(walls, pose, front_rad);
  const double glitch_share = noise_scale_ * kGlitchShare;
  travelled_m_ += distance(pose.position, last_.value_or(pose.position));
  const double rub = std::max(kLeastForce, kForcePerSpeed * (speed_mps - kSlowest));
  last_ = pose.position;
  std::array<RayReading, kTentacles> readings;
  for (const std::size_t k : order_) {
    const Ray& ray = robot.rays[k];
    const double clearance = clearances[k];
    // Clearances end at the reach: no wall can be felt to lie beyond it.
    touching_[k] = clearance < ray.reach_m - (touching_[k] ? 0.0 : kHysteresis);
    const double felt = clearance < ray.reach_m
                            ? std::clamp(clearance + calibration_bias_m_, 0.0, ray.reach_m)
                            : ray.reach_m;
    const double noise =
        noise_scale_ *
        (std::sqrt(noise_m_[k] * noise_m_[k] - kWhiteNoise * kWhiteNoise) * texture(k) +
         kWhiteNoise * random_.normal());
    double bend =
        calibrated_bend(ray.calibration, felt) + noise * bend_per_metre(ray.calibration, felt);
    const double glitch = random_.uniform();
    if (glitch < glitch_share) {
      bend = ray.calibration.bend_rad.back() * glitch / glitch_share;
    }
    const double force = noise_scale_ * kForceNoise * random_.normal();
    readings[k].value = rounded_to(bend, 1e4);
    readings[k].fsr_n = rounded_to(touching_[k] ? rub + force : std::abs(force), 1e2);
    readings[k].bearing_rad = k == kFront ? front_rad : kMissing;
  }
  return readings;
}

}  // namespace tcert
