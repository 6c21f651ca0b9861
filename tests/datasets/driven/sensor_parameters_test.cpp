#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"

namespace tcert {
namespace {

using namespace driven_test;

constexpr double kDigit = 0.5e-4;  // to which bends and positions are logged

DrivenTrial driven(const DriveParameters& parameters, std::uint64_t index) {
  DrivenDesign design = design_driven(parameters, 7, index);
  design.native_rates = true;
  return drive_trial(design, LineDriver(design.world));
}

DriveParameters without_noise() {
  DriveParameters parameters;
  parameters.time_limit_s = 40.0;
  parameters.noise_scale = 0.0;
  return parameters;
}

// Without noise a reading is the distance to the wall from where the robot is. Its pose is logged
// 20 times a second; between two of those it is at most 0.3 m/s x 25 ms from the nearer one.
TEST(SensorParameters, WithoutNoiseReadingsAreTrue) {
  const DrivenDesign design = design_driven(without_noise(), 7, 0);
  const WallIndex walls = walls_of(design.world, 1.0);
  const TrialLog log = driven(without_noise(), 0).trial.log;
  std::size_t compared = 0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < log.tactile.time_ns.size(); ++i) {
    while (at + 1 < log.pose.time_ns.size() && log.pose.time_ns[at] < log.tactile.time_ns[i]) {
      ++at;
    }
    if (std::abs(log.pose.time_ns[at] - log.tactile.time_ns[i]) > 200'000) {
      continue;
    }
    const auto clearances = cast_tentacles(walls, log.pose.poses[at]);
    for (std::size_t k = 0; k < kTentacles; ++k) {
      const Ray& ray = corpus_robot().rays[k];
      const double felt_m =
          calibrated_clearance(ray.calibration, log.tactile.readings[i * kTentacles + k].value);
      // A corner hides or shows a wall within a digit of the heading.
      if (std::abs(felt_m - clearances[k]) < 0.02) {
        EXPECT_NEAR(felt_m, clearances[k], 1e-3);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 20U);
}

// The seeds of all other draws stay what they were: with the scale at 1 nothing has changed, and
// the noise grows with it.
TEST(SensorParameters, TheScaleIsThatOfTheNoise) {
  DriveParameters parameters;
  parameters.time_limit_s = 15.0;
  const auto spread = [&](double scale) {
    parameters.noise_scale = scale;
    const TrialLog log = driven(parameters, 3).trial.log;
    double sum = 0.0;  // of what differs from sample to sample of a free tentacle
    std::size_t count = 0;
    for (std::size_t i = 1; i < log.tactile.time_ns.size(); ++i) {
      const RayReading& now = log.tactile.readings[i * kTentacles + kFront];
      if (now.fsr_n < 0.3 && std::abs(now.value) < 0.2) {
        sum += std::abs(now.value);
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  };
  EXPECT_LE(spread(0.0), kDigit);
  EXPECT_GT(spread(1.0), 20 * kDigit);
  EXPECT_GT(spread(3.0), 2.0 * spread(1.0));
}

TEST(SensorParameters, AJointSweepsTheFrontalTentacleAsItSays) {
  DriveParameters parameters = without_noise();
  parameters.sweep_rad = 1.2;
  parameters.sweep_hz = 0.5;
  const TrialLog log = driven(parameters, 1).trial.log;
  double least = 0.0;
  double most = 0.0;
  double fastest = 0.0;
  for (std::size_t i = 0; i < log.tactile.time_ns.size(); ++i) {
    const RayReading* of = &log.tactile.readings[i * kTentacles];
    EXPECT_TRUE(std::isnan(of[0].bearing_rad) && std::isnan(of[1].bearing_rad));
    least = std::min(least, of[kFront].bearing_rad);
    most = std::max(most, of[kFront].bearing_rad);
    if (i > 0) {
      const double seconds =
          1e-9 * static_cast<double>(log.tactile.time_ns[i] - log.tactile.time_ns[i - 1]);
      fastest = std::max(
          fastest,
          std::abs(of[kFront].bearing_rad - (of - kTentacles)[kFront].bearing_rad) / seconds);
    }
  }
  EXPECT_NEAR(least, -1.2, 0.001);
  EXPECT_NEAR(most, 1.2, 0.001);
  EXPECT_NEAR(fastest, 1.2 * 2.0 * std::numbers::pi * 0.5, 0.05);
}

}  // namespace
}  // namespace tcert
