#include "datasets/import/carmen_poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <table/random.hpp>
#include <vector>

#include "datasets/import/carmen_log.hpp"

namespace tcert {
namespace {

/// The odometry of a robot that drives round in circles, ten times a second.
Pose odometry_at(double time_s) {
  const double yaw = 0.4 * time_s;
  return {{std::sin(yaw), 1.0 - std::cos(yaw)}, std::remainder(yaw, 2.0 * M_PI)};
}

/// A scan a second, `late` after an ODOM record, and where `of` puts it then; the odometry that is
/// written after the scan is what `after` makes of it.
template <class Of>
CarmenTrack track(std::size_t scans, double late, const Of& of, bool repeated = false) {
  CarmenTrack made;
  for (std::size_t i = 0; i < scans; ++i) {
    for (int k = 0; k < 10; ++k) {
      made.odometry.push_back(odometry_at(static_cast<double>(i) + 0.1 * k));
    }
    made.odometry_before.push_back(made.odometry.size());
    const Pose pose = of(i, static_cast<double>(i) + 0.9 + late);
    made.laser.push_back(pose);
    made.robot.push_back(pose);
    if (repeated) {
      made.odometry.push_back(pose);
    }
  }
  return made;
}

/// On the chord between the records at 0.9 s and 1 s, as CARMEN interpolates.
Pose between(double time_s) {
  const double from = std::floor(10.0 * time_s) / 10.0;
  const Pose a = odometry_at(from);
  const Pose b = odometry_at(from + 0.1);
  const double share = (time_s - from) / 0.1;
  return {a.position + share * (b.position - a.position),
          a.yaw_rad + share * angle_between(a.yaw_rad, b.yaw_rad)};
}

TEST(OriginOf, FindsTheOdometryBeforeEachScanAndTheMotionSince) {
  const auto exact = [](std::size_t, double time) { return odometry_at(time); };
  EXPECT_EQ(origin_of(track(40, 0.0, exact).laser, track(40, 0.0, exact)), CarmenPoses::odometry);
  const auto interpolated = [](std::size_t, double time) { return between(time); };
  for (const double late : {-0.35, -0.05, 0.03, 0.08}) {
    const CarmenTrack some = track(40, late, interpolated);
    EXPECT_EQ(origin_of(some.laser, some), CarmenPoses::odometry) << late;
  }
}

/// GMapping writes the corrected pose into both places of a FLASER record, and then into the ODOM
/// record after it: neither says that it is the odometry.
TEST(OriginOf, TellsCorrectedPosesFromTheOdometryTheyStartedFrom) {
  table::RandomStream random(1, 0, 0);
  const auto corrected = [&](std::size_t, double time) {
    Pose pose = odometry_at(time);
    pose.position.x_m += 0.02 * random.normal();
    pose.position.y_m += 0.02 * random.normal();
    pose.yaw_rad += 0.01 * random.normal();
    return pose;
  };
  const CarmenTrack once = track(60, 0.0, corrected);
  EXPECT_EQ(origin_of(once.laser, once), CarmenPoses::corrected);
  const CarmenTrack twice = track(60, 0.0, corrected, true);
  EXPECT_EQ(origin_of(twice.laser, twice), CarmenPoses::corrected);
}

TEST(OriginOf, IsNotKnownWithoutOdometry) {
  CarmenTrack alone = track(20, 0.0, [](std::size_t, double time) { return odometry_at(time); });
  alone.odometry.clear();
  alone.odometry_before.assign(20, 0);
  EXPECT_EQ(origin_of(alone.laser, alone), CarmenPoses::unknown);
}

TEST(LaserMount, IsWhereTheRecordsAgreeOnIt) {
  CarmenTrack some = track(40, 0.0, [](std::size_t, double time) { return odometry_at(time); });
  const Pose mount{{0.25, -0.05}, 0.1};
  for (std::size_t i = 0; i < some.laser.size(); ++i) {
    some.laser[i] = compose(some.robot[i], mount);
  }
  const std::optional<Pose> found = laser_mount(some, true);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->position.x_m, 0.25, 1e-12);
  EXPECT_NEAR(found->position.y_m, -0.05, 1e-12);
  EXPECT_NEAR(found->yaw_rad, 0.1, 1e-12);
  const Pose back = compose(compose(some.robot[7], mount), seen_from(mount, {}));
  EXPECT_NEAR(distance(back.position, some.robot[7].position), 0.0, 1e-12);
}

TEST(LaserMount, IsNoneBetweenCorrectedPosesAndRawOnes) {
  CarmenTrack drifting = track(40, 0.0, [](std::size_t, double time) { return odometry_at(time); });
  for (std::size_t i = 0; i < drifting.laser.size(); ++i) {
    drifting.laser[i].position.x_m += 0.01 * static_cast<double>(i);
  }
  EXPECT_FALSE(laser_mount(drifting, true));
  // A fixed offset of the frame looks like a mount while the robot drives straight.
  CarmenTrack straight;
  for (int i = 0; i < 20; ++i) {
    straight.robot.push_back({{0.5 * i, 0.0}, 0.0});
    straight.laser.push_back({{0.5 * i + 0.3, 0.0}, 0.0});
  }
  EXPECT_FALSE(laser_mount(straight, true));
  EXPECT_TRUE(laser_mount(straight, false)) << "of records that are defined to hold it";
}

TEST(LaserMount, OfOneFrameIsZeroToTheLastBit) {
  const CarmenTrack same =
      track(20, 0.0, [](std::size_t, double time) { return odometry_at(time); });
  EXPECT_EQ(laser_mount(same, true)->position, Point{});
  EXPECT_EQ(laser_mount(same, true)->yaw_rad, 0.0);
}

/// The pose that a log is read with is that of the robot, and it is that one that the odometry is
/// compared with: a laser 0.2 m ahead does not hide that the poses are raw.
TEST(ReadCarmenLog, ComparesTheRobotsPoseWithTheOdometryAndNotTheLasers) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    const Pose robot = odometry_at(i);
    const Pose laser = compose(robot, {{0.2, 0.0}, 0.0});
    const auto words = [](const Pose& pose) {
      return std::to_string(pose.position.x_m) + " " + std::to_string(pose.position.y_m) + " " +
             std::to_string(pose.yaw_rad) + " ";
    };
    const std::string time = std::to_string(i);
    text += "ODOM " + words(robot) + "0 0 0 " + time + " h " + time + "\n";
    text += "FLASER 2 1 1 " + words(laser) + words(robot) + time + " h " + time + "\n";
  }
  table::DiagnosticGroups problems;
  CarmenReading reading;
  reading.fov_rad = 1.0;
  const CarmenLog log = read_carmen_log(table::Bytes::copy_of(text), "a.log", reading, problems);
  EXPECT_EQ(log.origin, CarmenPoses::odometry);
  EXPECT_NEAR(log.mount.value().position.x_m, 0.2, 1e-5);
  EXPECT_NEAR(distance(log.poses[9].position, odometry_at(9).position), 0.0, 1e-5);
}

}  // namespace
}  // namespace tcert
