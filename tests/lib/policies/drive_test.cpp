#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/policy.hpp>
#include <vector>

#include "lib/policies/felt_run.hpp"

namespace tcert::policies {
namespace {

constexpr double kPeriod = 0.02;

// Walls as segments, felt by rays that are cast exactly; a round body that stops where it would
// enter one. No noise, no latency.
struct Wall {
  Point a;
  Point b;
};

struct World {
  std::vector<Wall> walls;
  Point goal;
};

double cast(const World& world, Point from, Point u, double reach_m) {
  double nearest_m = reach_m;
  for (const auto& [a, b] : world.walls) {
    const double across = cross(u, b - a);
    if (across == 0.0) {
      continue;
    }
    const double along_m = cross(a - from, b - a) / across;
    const double share = cross(a - from, u) / across;
    if (along_m >= 0.0 && share >= 0.0 && share <= 1.0) {
      nearest_m = std::min(nearest_m, along_m);
    }
  }
  return nearest_m;
}

double distance_to(const Wall& wall, Point p) {
  const Point along = wall.b - wall.a;
  const double share = std::clamp(dot(p - wall.a, along) / dot(along, along), 0.0, 1.0);
  return distance(p, wall.a + share * along);
}

// Seconds until the body is within 0.1 m of G; infinity if that takes longer than `most_s`.
double time_to_goal(Policy& policy, const PolicySetup& setup, const World& world, double most_s) {
  Senses senses;
  senses.goal = world.goal;
  std::vector<RayReading> readings(setup.robot.rays.size());
  senses.tick.rays = readings;
  Pose pose;
  for (double now_s = 0.0; now_s < most_s; now_s += kPeriod) {
    if (distance(pose.position, world.goal) < 0.1) {
      return now_s;
    }
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const Ray& ray = setup.robot.rays[i];
      const double clearance_m = cast(world,
                                      transform(pose, ray.mount),
                                      direction(pose.yaw_rad + ray.bearing_rad),
                                      ray.reach_m);
      const bool touches = clearance_m < ray.reach_m;
      readings[i] = {
          ray.kind == RayKind::bend ? calibrated_bend(ray.calibration, clearance_m) : clearance_m,
          touches ? 1.0 : 0.0};
    }
    senses.tick.pose = pose;
    senses.tick.time_ns += 20'000'000;
    const Command command = policy.step(senses);
    pose.yaw_rad += kPeriod * command.yaw_rate_rps;
    const Point moved = pose.position + kPeriod * command.speed_mps * direction(pose.yaw_rad);
    senses.bump.reset();
    bool enters = false;
    for (const Wall& wall : world.walls) {
      if (distance_to(wall, moved) < 0.5 * setup.robot.body_width_m &&
          distance_to(wall, moved) < distance_to(wall, pose.position)) {
        enters = true;
        const Point along = wall.b - wall.a;
        const double share = std::clamp(dot(moved - wall.a, along) / dot(along, along), 0.0, 1.0);
        const Point to_wall = wall.a + share * along - moved;
        senses.bump = Bump{angle_between(pose.yaw_rad, std::atan2(to_wall.y_m, to_wall.x_m)), 50.0};
      }
    }
    senses.travel_m += enters ? 0.0 : kPeriod * std::abs(command.speed_mps);
    pose.position = enters ? pose.position : moved;
  }
  return std::numeric_limits<double>::infinity();
}

PolicySetup open_field() {
  PolicySetup setup = two_lobes();
  setup.line.lobes.clear();
  setup.line.low = {-1.0, -3.0};
  setup.line.high = {5.0, 3.0};
  return setup;
}

// Right value 1, of a body that does at once what it is told: 3.9 m at 0.17 m/s, 22.94 s.
TEST(Policies, DriveStraightToTheGoalWhereNothingIs) {
  const PolicySetup setup = open_field();
  for (const PolicyKind kind : kAllPolicies) {
    Policy policy(kind, setup);
    EXPECT_NEAR(time_to_goal(policy, setup, {{}, {4.0, 0.0}}, 100.0), 3.9 / 0.17, kPeriod)
        << name_of(kind);
  }
}

TEST(Policies, FollowTheLineToTheGoal) {
  PolicySetup setup = open_field();
  setup.line.lobes = {{{{{0.0, 0.0}, {1.5, 1.0}, {3.0, 0.0}}}}};
  for (const PolicyKind kind :
       {PolicyKind::m1, PolicyKind::m3, PolicyKind::tvfh, PolicyKind::cb_v}) {
    Policy policy(kind, setup);
    // 2 sqrt(1.5^2 + 1) + 0.9 = 4.506 m along the line, a little less round the corner.
    const double time_s = time_to_goal(policy, setup, {{}, {4.0, 0.0}}, 100.0);
    EXPECT_GT(time_s, 4.2 / 0.17) << name_of(kind);
    EXPECT_LT(time_s, 4.7 / 0.12) << name_of(kind);
  }
}

// Right value 6: a pocket that is open towards the robot; G lies behind it.
TEST(Policies, APocketHoldsM1AndNotThePlanner) {
  PolicySetup setup = open_field();
  setup.robot.min_turn_radius_m = 0.0;
  const World pocket{
      {{{1.0, 0.9}, {2.0, 0.9}}, {{2.0, 0.9}, {2.0, -0.9}}, {{2.0, -0.9}, {1.0, -0.9}}},
      {4.0, 0.2}};
  Policy reactive(PolicyKind::m1, setup);
  EXPECT_TRUE(std::isinf(time_to_goal(reactive, setup, pocket, 180.0)));
  Policy planner(PolicyKind::td_star_lite, setup);
  EXPECT_LT(time_to_goal(planner, setup, pocket, 180.0), 180.0);
}

TEST(Policies, TheDeeperTheTouchTheSlower) {
  for (const PolicyKind kind : {PolicyKind::m1, PolicyKind::m2, PolicyKind::m3}) {
    PolicySetup setup = open_field();
    double last_mps = setup.parameters.cruise_mps;
    for (int i = 0; i <= 12; ++i) {
      Policy policy(kind, setup);
      std::vector<RayReading> readings(setup.robot.rays.size());
      readings[0] = readings[1] = {0.1 * i, 0.0};
      Senses senses;
      senses.goal = {4.0, 0.0};
      senses.tick.rays = readings;
      const double speed_mps = policy.step(senses).speed_mps;
      EXPECT_LE(speed_mps, last_mps);
      last_mps = speed_mps;
    }
    // At full depth the share that caution leaves.
    EXPECT_NEAR(last_mps, 0.17 * (1.0 - 0.4), 1e-15) << name_of(kind);
  }
}

}  // namespace
}  // namespace tcert::policies
