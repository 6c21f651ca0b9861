#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tcert/tick.hpp>
#include <witness/samples.hpp>

#include "lib/witness/walls.hpp"

namespace tcert::witness {
namespace {

constexpr std::int64_t kMs = 1'000'000;

Robot one_ray() {
  Robot robot;
  robot.rays = {range_ray("left", {0.0, 0.0}, 0.5 * std::numbers::pi, 0.5)};
  return robot;
}

TEST(Samples, PosesAreInterpolatedWithinTheBridgeOnly) {
  const std::vector<std::int64_t> pose_ns{0, 50 * kMs, 250 * kMs, 300 * kMs};
  const std::vector<Pose> poses{
      {{0.0, 0.0}, 3.1}, {{0.1, 0.0}, -3.1}, {{0.5, 0.0}, -3.0}, {{0.6, 0.2}, -3.0}};
  const std::vector<std::int64_t> touch_ns{
      -kMs, 0, 25 * kMs, 50 * kMs, 100 * kMs, 275 * kMs, 300 * kMs, 301 * kMs};
  const std::vector<RayReading> values{{0.1}, {0.2}, {0.3}, {0.4}, {0.9}, {0.5}, {kMissing}, {0.1}};
  const Samples samples = at_touch_times(one_ray(), {pose_ns, poses}, {touch_ns, values}, {}, 0.11);
  ASSERT_EQ(samples.size(), 5U);
  EXPECT_NEAR(samples.poses[1].position.x_m, 0.05, 1e-12);
  // Half the way from 3.1 over pi to -3.1.
  EXPECT_NEAR(std::abs(std::remainder(samples.poses[1].yaw_rad, 2.0 * std::numbers::pi)),
              std::numbers::pi,
              1e-12);
  EXPECT_NEAR(samples.poses[3].position.y_m, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(samples.clearances_m[3], 0.5);
  EXPECT_TRUE(std::isnan(samples.clearances_m[4]));
  EXPECT_EQ(samples.breaks, (std::vector<std::uint8_t>{1, 0, 0, 0, 0}));
}

TEST(Samples, ABreakIsMarkedAndNotInterpolatedAcross) {
  const std::vector<std::int64_t> pose_ns{0, 100 * kMs, 200 * kMs};
  const std::vector<Pose> poses(3);
  const std::vector<std::int64_t> touch_ns{0, 50 * kMs, 120 * kMs, 150 * kMs, 200 * kMs};
  const std::vector<RayReading> values(5, {0.3});
  const std::vector<std::int64_t> breaks{110 * kMs};
  const Samples samples =
      at_touch_times(one_ray(), {pose_ns, poses}, {touch_ns, values}, breaks, 0.11);
  ASSERT_EQ(samples.size(), 3U);  // not those at 120 and 150 ms
  EXPECT_EQ(samples.breaks, (std::vector<std::uint8_t>{1, 0, 1}));
}

TEST(Samples, ClearancesAreThoseOfTheCalibrationWithinTheReach) {
  Ray ray{"left", {}, 0.0, 0.4, RayKind::bend, {{0.0, 1.0}, {0.5, 0.0}}};
  EXPECT_DOUBLE_EQ(clearance_of(ray, 0.6), 0.2);
  EXPECT_DOUBLE_EQ(clearance_of(ray, -1.0), 0.4);
  EXPECT_TRUE(std::isnan(clearance_of(ray, kMissing)));
}

TEST(Samples, AReadingIsFeltWhereItsJointPointed) {
  const std::vector<std::int64_t> at{0, 10 * kMs, 20 * kMs};
  const std::vector<Pose> poses(3, Pose{{1.0, 2.0}, 0.5});
  const std::vector<RayReading> readings{{0.3, 0.0, -0.2}, {0.3, 0.0}, {0.3, 0.0, 90.0}};
  const Samples samples = at_touch_times(one_ray(), {at, poses}, {at, readings}, {}, 0.0);
  EXPECT_EQ(samples.direction_of(one_ray(), 0, 0), direction(0.5 - 0.2));
  EXPECT_EQ(samples.direction_of(one_ray(), 1, 0), direction(0.5 + 0.5 * std::numbers::pi));
  EXPECT_EQ(samples.clearances_m[1], 0.3);
  EXPECT_TRUE(std::isnan(samples.clearances_m[2]));  // degrees: nobody knows where
}

TEST(Samples, AGlitchIsTakenOutAndAWallIsNot) {
  const Robot robot = one_ray();
  Samples samples;
  samples.rays = 1;
  const std::vector<double> read{0.4, 0.4, 0.1, 0.4, 0.398, 0.3, 0.3, 0.3};
  for (std::size_t i = 0; i < read.size(); ++i) {
    samples.poses.push_back({{0.004 * static_cast<double>(i), 0.0}, 0.0});
    samples.breaks.push_back(0);
  }
  samples.clearances_m = read;
  drop_glitches(samples, robot, 0.5);
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(std::isnan(samples.clearances_m[i]), i == 2) << i;
  }
}

}  // namespace
}  // namespace tcert::witness
