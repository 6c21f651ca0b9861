#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"

namespace tcert {
namespace {

using namespace driven_test;

TEST(Referee, CountsAnArrivalByStandingInGForASecond) {
  DrivenDesign design = design_of(corridor(3.0, 1.2));
  design.native_rates = true;
  const DrivenTrial driven = drive_trial(design, Steady{0.2});
  ASSERT_EQ(driven.trial.row.end_reason, EndReason::goal);
  EXPECT_TRUE(*driven.trial.row.success);
  const PoseStream& pose = driven.trial.log.pose;
  const std::int64_t end = pose.time_ns.back();
  for (std::size_t i = 0; i < pose.time_ns.size(); ++i) {
    if (pose.time_ns[i] > end - 900'000'000) {
      EXPECT_TRUE(contains(*design.world.world.goal, pose.poses[i].position));
      EXPECT_LT(distance(pose.poses[i].position, pose.poses.back().position), 0.01);
    }
  }
  // It was told to stand 12 cm inside, although its policy drives on.
  EXPECT_NEAR(pose.poses.back().position.x_m, 2.7 + 0.12 + 0.2 * 0.0196 + 0.04, 0.01);
  EXPECT_EQ(driven.trial.log.control.speed_cmd_mps.back(), 0.0);
  EXPECT_GT(1e-9 * static_cast<double>(end), *driven.trial.row.time_s + 1.0);
}

// A chord of 0.10 m through the edge of G: in and out again before it is told to stand.
TEST(Referee, DoesNotCountGrazingG) {
  DrivenDesign design = design_of(corridor(3.0, 1.5));
  const double off = std::sqrt(0.3 * 0.3 - 0.05 * 0.05);
  design.world.start = {{0.0, off}, 0.0};
  design.parameters.time_limit_s = 60.0;
  const DrivenTrial driven = drive_trial(design, Steady{0.2});
  EXPECT_NE(driven.trial.row.end_reason, EndReason::goal);
  EXPECT_FALSE(*driven.trial.row.success);
  EXPECT_GT(*driven.trial.row.time_s, 20.0);
}

// Told to stand so late that the body slides out over the far edge.
TEST(Referee, DoesNotCountLeavingGAgain) {
  DrivenDesign design = design_of(corridor(3.0, 1.2));
  design.parameters.stop_inside_m = 0.58;
  design.parameters.time_limit_s = 60.0;
  const DrivenTrial driven = drive_trial(design, Steady{0.3});
  EXPECT_NE(driven.trial.row.end_reason, EndReason::goal);
}

TEST(Referee, CountsTheEntryAfterWhichTheRobotStayed) {
  DrivenDesign design = design_of(corridor(3.0, 1.2));
  design.parameters.stop_inside_m = 0.2;
  // In by 10 cm, out again for 5 s, in for good.
  const auto there_and_back = [](const policies::Senses& senses) -> policies::Command {
    const double x = senses.tick.pose.position.x_m;
    const double t = 1e-9 * static_cast<double>(senses.tick.time_ns);
    static constexpr double kTurn = 15.5;
    return {t > kTurn && t < kTurn + 5.0 && x > 2.0 ? -0.1 : 0.18, 0.0};
  };
  const DrivenTrial driven = drive_trial(design, there_and_back);
  ASSERT_EQ(driven.trial.row.end_reason, EndReason::goal);
  EXPECT_GT(*driven.trial.row.time_s, 20.5);
  EXPECT_GT(*driven.trial.row.distance_m, 3.0);
}

TEST(Referee, EndsAfterTheTimeLimit) {
  DrivenDesign design = design_of(corridor(3.0, 1.2));
  design.parameters.time_limit_s = 9.0;
  const DrivenTrial driven = drive_trial(design, Steady{0.1});
  EXPECT_EQ(driven.trial.row.end_reason, EndReason::timeout);
  EXPECT_EQ(*driven.trial.row.time_s, 9.0);
  EXPECT_FALSE(*driven.trial.row.success);
  EXPECT_LE(driven.trial.log.pose.time_ns.back(), 9'000'000'000);
}

// 300 * 0.2 + 15 = 75 N against thresholds of one log-normal: the share of collisions is the normal
// distribution function of log(75 / median) / 0.3.
TEST(Referee, EndsAsACollisionAboveADrawnForce) {
  DriveParameters parameters;
  parameters.crash_force_n = 90.0;
  parameters.crash_log_sd = 0.3;
  parameters.time_limit_s = 12.0;
  int collisions = 0;
  constexpr int kRuns = 600;
  for (std::uint64_t i = 0; i < kRuns; ++i) {
    DrivenDesign design = design_of(gated_corridor(3.0, 1.2, 0.1), parameters);
    design.index = i;
    const DrivenTrial driven = drive_trial(design, Steady{0.2});
    const bool collided = driven.trial.row.end_reason == EndReason::collision;
    collisions += collided ? 1 : 0;
    ASSERT_EQ(collided, driven.events.peak_force_n > driven.events.crash_force_n);
    if (!collided) {
      ASSERT_NEAR(driven.events.peak_force_n, 75.0, 1e-9);
    }
  }
  const double share = 0.5 * std::erfc(-std::log(75.0 / 90.0) / 0.3 / std::numbers::sqrt2);
  EXPECT_NEAR(collisions, kRuns * share, 4.0 * std::sqrt(kRuns * share * (1.0 - share)));
}

// It meets the closed gate at 1.425 - 0.225 m and pushes from then on: above 40 N for the rest.
TEST(Referee, CountsForceStallsAndTheWedge) {
  DrivenDesign design = design_of(gated_corridor(3.0, 1.2, 0.1), uncrashable());
  const DrivenTrial driven = drive_trial(design, Steady{0.2});
  EXPECT_EQ(driven.trial.row.end_reason, EndReason::wedged);
  EXPECT_EQ(driven.events.bumps, 1U);
  EXPECT_EQ(driven.events.stalls, 5U);
  EXPECT_EQ(driven.events.recoveries, 0U);
  EXPECT_NEAR(driven.events.time_above_s, 25.0, 0.2);
  EXPECT_NEAR(
      *driven.trial.row.distance_m, 1.5 - 0.075 - std::sqrt(0.225 * 0.225 - 0.05 * 0.05), 1e-3);
}

}  // namespace
}  // namespace tcert
