#include "datasets/driven/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <table/random.hpp>

#include "datasets/driven/scripted.hpp"

namespace tcert {
namespace {

using driven_test::box;
using driven_test::gated_corridor;
using driven_test::kBodyRadius;

/// One wall, its face along x = 1.
World wall_ahead() {
  World world;
  world.bounds = {{-3.0, -3.0}, {3.0, 3.0}};
  world.obstacles = {box({1.0, -2.0}, {1.2, 2.0})};
  return world;
}

struct Ride {
  Point position;
  double peak_force_n = 0.0;
};

Ride ride(const WallIndex& walls,
          const DriveParameters& parameters,
          const Pose& start,
          const policies::Command& command,
          double seconds,
          double step_s) {
  Body body(parameters, walls, kBodyRadius, start);
  Ride ride;
  for (int i = 0; i < static_cast<int>(std::round(seconds / step_s)); ++i) {
    body.advance(step_s, command);
    ride.peak_force_n = std::max(ride.peak_force_n, body.hold().force_n);
  }
  ride.position = body.pose().position;
  return ride;
}

// v(t) = a t, then the command: x = v t - v^2 / (2 a).
TEST(RateLimited, IsExactWhateverTheStep) {
  for (const double step : {0.01, 0.002, 0.03, 0.0137}) {
    RateLimited speed;
    double way = 0.0;
    double time = 0.0;
    while (time < 2.0) {
      way += step * speed.advance(0.25, 0.5, step);
      time += step;
    }
    EXPECT_NEAR(way, 0.25 * time - 0.25 * 0.25 / (2.0 * 0.5), 1e-12);
    EXPECT_EQ(speed.value(), 0.25);
  }
}

TEST(Body, DrivesAndTurnsWithinItsLimits) {
  const WallIndex walls(wall_ahead(), kSensingRange);
  DriveParameters parameters;
  Body body(parameters, walls, kBodyRadius, {{-2.0, 0.0}, 0.0});
  double last_speed = 0.0;
  for (int i = 0; i < 300; ++i) {
    body.advance(0.01, {9.0, i < 100 ? 0.0 : 9.0});
    EXPECT_LE(body.forward_mps(), parameters.most_speed_mps + 1e-12);
    EXPECT_LE(body.forward_mps() - last_speed, 0.01 * parameters.acceleration_mps2 + 1e-12);
    last_speed = body.forward_mps();
  }
  // From 1 s on it turns: up to 1.2 rad/s at 4 rad/s^2 costs half of 0.3 s.
  EXPECT_NEAR(body.pose().yaw_rad, 1.2 * (2.0 - 0.15), 1e-9);
  EXPECT_EQ(body.hold().force_n, 0.0);
  body.advance(0.01, {std::nan(""), 0.0});
  EXPECT_LT(body.forward_mps(), last_speed);
}

TEST(Body, KeepsItsTurnRadius) {
  const WallIndex walls(wall_ahead(), kSensingRange);
  DriveParameters parameters;
  parameters.turn_radius_m = 0.35;
  Body still(parameters, walls, kBodyRadius, {{-1.0, 0.0}, 0.0});
  still.advance(1.0, {0.0, 1.0});
  EXPECT_EQ(still.pose().yaw_rad, 0.0);
  // A full circle of that radius: its two ends of a diameter along y are two radii apart.
  Body round(parameters, walls, kBodyRadius, {{-1.0, -1.0}, 0.0});
  double least_y = 0.0;
  double most_y = -2.0;
  for (int i = 0; i < 3000; ++i) {
    round.advance(0.01, {0.2, 5.0});
    least_y = std::min(least_y, round.pose().position.y_m);
    most_y = std::max(most_y, round.pose().position.y_m);
  }
  EXPECT_NEAR(most_y - least_y, 0.70, 0.002);
}

// 300 N s/m times 0.2 m/s and 15 N.
TEST(Body, IsStoppedAtAWallByAForceThatGrowsWithItsSpeed) {
  const WallIndex walls(wall_ahead(), kSensingRange);
  double last = 0.0;
  for (const double speed : {0.05, 0.10, 0.20, 0.30}) {
    const Ride at = ride(walls, {}, {{0.0, 0.3}, 0.0}, {speed, 0.0}, 20.0, 0.01);
    EXPECT_NEAR(at.position.x_m, 1.0 - kBodyRadius, 1e-9);
    EXPECT_EQ(at.position.y_m, 0.3);
    EXPECT_NEAR(at.peak_force_n, 300.0 * speed + 15.0, 1e-9);
    EXPECT_GT(at.peak_force_n, last);
    last = at.peak_force_n;
  }
}

TEST(Body, FeelsNothingWhereItOnlyStandsAtAWall) {
  const WallIndex walls(wall_ahead(), kSensingRange);
  Body body({}, walls, kBodyRadius, {{1.0 - kBodyRadius, 0.0}, 0.0});
  body.advance(0.01, {});
  EXPECT_EQ(body.hold().force_n, 0.0);
  body.advance(0.01, {-0.1, 0.0});
  EXPECT_EQ(body.hold().force_n, 0.0);
}

// Into the wall at 30 degrees from it: the wall takes v sin 30 and friction mu times its force.
TEST(Body, SlidesAlongAWallWithFriction) {
  const WallIndex walls(wall_ahead(), kSensingRange);
  const DriveParameters parameters;
  const double yaw = std::numbers::pi / 3.0;
  Body body(parameters, walls, kBodyRadius, {{0.7, -1.0}, yaw});
  for (int i = 0; i < 400; ++i) {
    body.advance(0.01, {0.2, 0.0});
  }
  const double force = 300.0 * 0.2 * 0.5 + 15.0;
  EXPECT_NEAR(body.hold().force_n, force, 1e-9);
  EXPECT_NEAR(body.hold().towards.x_m, 1.0, 1e-9);
  EXPECT_NEAR(body.speed_mps(), 0.2 * std::sqrt(0.75) - 0.3 * force / 300.0, 1e-9);
  EXPECT_NEAR(body.pose().position.x_m, 1.0 - kBodyRadius, 1e-9);
}

// tan of the angle to the wall below (1 + F_0 / (D v sin)) times the friction: it sticks.
TEST(Body, SticksWhereFrictionHoldsIt) {
  const WallIndex walls(wall_ahead(), kSensingRange);
  const Ride at = ride(walls, {}, {{0.7, 0.0}, 0.25}, {0.2, 0.0}, 10.0, 0.01);
  EXPECT_LT(at.position.y_m, 0.05);
}

// Square and glancing hits at a jaw's corner, and wedges, at up to 0.2 m/s, which are 75 N. The
// tolerance is 1 N: what a body turning at 0.05 rad/s and speeding up by 0.5 m/s^2 makes of the way
// and the speed within one step of 10 ms is less.
TEST(Body, IsHitAsHardWhateverTheStep) {
  const WallIndex walls(gated_corridor(3.0, 1.2, 0.44).world, kSensingRange);
  table::RandomStream random(1, 0x7465'0004, 0);
  double most = 0.0;
  double sum = 0.0;
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose start{{0.0, random.uniform(-0.3, 0.3)}, random.uniform(-0.3, 0.3)};
    const policies::Command command{random.uniform(0.05, 0.2), random.uniform(-0.05, 0.05)};
    const auto peak = [&](double step_s) {
      return ride(walls, {}, start, command, 12.0, step_s).peak_force_n;
    };
    const double fine = peak(0.002);
    const double coarse = peak(0.01);
    ASSERT_EQ(fine > 0.0, coarse > 0.0) << i;
    hits += fine > 0.0 ? 1 : 0;
    sum += std::abs(coarse - fine);
    most = std::max(most, std::abs(coarse - fine));
  }
  std::printf("%d peak forces at 10 ms and at 2 ms differ by %.3f N on average, %.3f N at most\n",
              hits,
              sum / hits,
              most);
  EXPECT_GT(hits, 200);
  EXPECT_LT(most, 1.0);
}

}  // namespace
}  // namespace tcert
