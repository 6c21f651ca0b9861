#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "datasets/corpus/figure_eight.hpp"
#include "datasets/corpus/trial_course.hpp"
#include "datasets/corpus/wall_index.hpp"

namespace tcert {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(FigureEight, LanesMeetAt29To49Degrees) {
  for (const auto& [radius, angle] : {std::pair{0.6, 28.96}, std::pair{1.0, 49.25}}) {
    const FigureEight course{radius, 1.2};
    const Pose up = lane_pose(course, {false, true}, lane_length(course));
    const Pose down = lane_pose(course, {false, false}, lane_length(course));
    EXPECT_NEAR(norm(up.position), 0.0, 1e-12);
    EXPECT_NEAR(norm(down.position), 0.0, 1e-12);
    EXPECT_NEAR(std::abs(angle_between(up.yaw_rad, down.yaw_rad)), angle * kDegree, 1e-3);
  }
}

TEST(FigureEight, LanesAreSmoothAndOfUnitSpeed) {
  const FigureEight course{0.7, 1.2};
  for (const Lane lane :
       {Lane{false, true}, Lane{false, false}, Lane{true, true}, Lane{true, false}}) {
    for (double s = 0.01; s < lane_length(course); s += 0.01) {
      const Pose before = lane_pose(course, lane, s - 0.01);
      const Pose after = lane_pose(course, lane, s);
      EXPECT_NEAR(distance(before.position, after.position), 0.01, 1e-5);
      EXPECT_LT(std::abs(angle_between(before.yaw_rad, after.yaw_rad)), 0.01 / 0.7 + 1e-9);
      const Point step = after.position - before.position;
      EXPECT_GT(dot(step, direction(after.yaw_rad)), 0.0099);
    }
  }
}

TEST(FigureEight, WallsStandHalfALaneFromTheCentreLine) {
  for (const double radius : {0.7, 0.85, 1.0}) {
    const FigureEight course{radius, 1.2};
    const WallIndex walls(build_world(course, {}), 0.8);
    for (double s = 0.3; s < walled_length(course) - 0.05; s += 0.05) {
      for (const Lane lane : {Lane{false, true}, Lane{true, false}}) {
        const Pose pose = lane_pose(course, lane, s);
        for (const double side : {-0.5, 0.5}) {
          const Point u = direction(pose.yaw_rad + side * std::numbers::pi);
          EXPECT_NEAR(walls.cast(pose.position, pose.position, u, 0.79), 0.6, 0.003) << s;
        }
      }
    }
  }
}

TEST(FigureEight, LeavesStartAndGoalFree) {
  for (double radius = 0.6; radius <= 1.0; radius += 0.05) {
    for (const double width : {1.14, 1.2, 1.26}) {
      const FigureEight course{radius, width};
      const WallIndex walls(build_world(course, {}), 0.8);
      for (const Region& region : {course_start(), course_goal()}) {
        const Disc disc = std::get<Disc>(region);
        for (double bearing = 0.0; bearing < 6.2; bearing += 0.1) {
          EXPECT_GE(walls.cast(disc.centre, disc.centre, direction(bearing), 0.79), disc.radius_m);
        }
      }
      EXPECT_TRUE(contains(course_start(), lane_pose(course, {false, true}, 0.0).position));
      EXPECT_TRUE(contains(course_goal(), lane_pose(course, {true, true}, 0.0).position));
    }
  }
}

TEST(FigureEight, AGateIsAsWideAsStated) {
  const FigureEight course{0.8, 1.2};
  const Gate gate{{true, true}, 0.8, 0.015, 0.5, 0.15};
  const WallIndex walls(build_world(course, {gate}), 0.8);
  const Pose pose = lane_pose(course, gate.lane, gate.along_m);
  const double left = walls.cast(
      pose.position, pose.position, direction(pose.yaw_rad + 0.5 * std::numbers::pi), 0.7);
  const double right = walls.cast(
      pose.position, pose.position, direction(pose.yaw_rad - 0.5 * std::numbers::pi), 0.7);
  EXPECT_NEAR(left, 0.265, 2e-4);
  EXPECT_NEAR(right, 0.235, 2e-4);
}

TEST(WallIndex, PushesADiscOutOfAWallAndSaysWhereItCannot) {
  World world;
  world.bounds = {{-2.0, -2.0}, {2.0, 2.0}};
  world.obstacles = {Polygon{{{-1.0, 0.2}, {1.0, 0.2}, {1.0, 1.0}, {-1.0, 1.0}}},
                     Polygon{{{-1.0, -0.2}, {1.0, -0.2}, {1.0, -1.0}, {-1.0, -1.0}}}};
  const WallIndex walls(world, 0.7);
  const auto [slid, is_free] = walls.pushed_out({0.0, 0.05}, 0.18);
  EXPECT_TRUE(is_free);
  EXPECT_NEAR(slid.x_m, 0.0, 1e-12);
  EXPECT_NEAR(slid.y_m, 0.02, 1e-12);
  EXPECT_FALSE(walls.pushed_out({0.0, 0.0}, 0.21).second);
}

TEST(DrawCourse, IsPassableForASuccessAndNotForAFailure) {
  CorpusOptions options;
  for (const double effect : {0.0, 1.0}) {
    options.effect = effect;
    for (const TrialDesign& design : design_block(options, 0)) {
      const TrialCourse trial = draw_course(design);
      EXPECT_GE(trial.gates.size(), 4U);
      EXPECT_LE(trial.gates.size(), 8U);
      EXPECT_EQ(trial.wedge.has_value(), !design.success);
      EXPECT_EQ(trial.true_margin_m > 0.0, design.success);
      EXPECT_GE(trial.course.radius_m, 0.6);
      EXPECT_LE(trial.course.radius_m, 1.0);
      for (const Gate& gate : trial.gates) {
        EXPECT_GE(gate.length_m, 0.10);
        EXPECT_LE(gate.along_m, 1.5);
        EXPECT_LE(gate.along_m, walled_length(trial.course));
      }
      if (trial.wedge) {
        const Gate& wedge = trial.gates[*trial.wedge];
        EXPECT_TRUE(wedge.lane.at_goal);
        EXPECT_GT(2.0 * lane_length(trial.course) - wedge.along_m, 5.6);
      }
    }
  }
}

TEST(DrawCourse, WithoutEffectTheOutcomeChangesNothingButTheWedge) {
  CorpusOptions options;
  options.effect = 0.0;
  for (TrialDesign design : design_block(options, 0)) {
    design.success = true;
    const TrialCourse success = draw_course(design);
    design.success = false;
    const TrialCourse failure = draw_course(design);
    ASSERT_EQ(success.gates.size(), failure.gates.size());
    for (std::size_t i = 0; i < success.gates.size(); ++i) {
      EXPECT_EQ(success.gates[i].along_m, failure.gates[i].along_m);
      EXPECT_EQ(success.gates[i].offset_m, failure.gates[i].offset_m);
      EXPECT_EQ(success.gates[i].width_m == failure.gates[i].width_m, i != *failure.wedge);
    }
  }
}

}  // namespace
}  // namespace tcert
