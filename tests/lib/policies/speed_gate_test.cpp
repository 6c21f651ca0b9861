#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tcert/guarded_drive.hpp>
#include <tcert/speed_gate.hpp>

namespace tcert::policies {
namespace {

constexpr SpeedLaw kSquash{SpeedLawKind::squash, 0.08, 0.22, 10.0};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

PolicyParameters creeping_at(double creep_mps) {
  PolicyParameters parameters;
  parameters.cruise_mps = 0.2;
  parameters.max_yaw_rate_rps = 0.6;
  parameters.creep_mps = creep_mps;
  return parameters;
}

// Margin 0.1 m at beta 10: half way from 0.08 to 0.22, 0.15 m/s.
TEST(SpeedGate, TheLawReplacesTheCruiseAndCautionStays) {
  const PolicyParameters parameters = creeping_at(0.04);
  const Command full = gated({0.2, 0.4}, kSquash, 0.1, parameters);
  EXPECT_NEAR(full.speed_mps, 0.15, 1e-15);
  EXPECT_NEAR(full.yaw_rate_rps, 0.3, 1e-15) << "the same curvature";
  EXPECT_NEAR(gated({0.1, 0.2}, kSquash, 0.1, parameters).speed_mps, 0.075, 1e-15);
}

TEST(SpeedGate, CreepsWithoutMarginSoThatTravelCanBringOne) {
  const PolicyParameters parameters = creeping_at(0.04);
  for (const double margin_m : {0.0, -0.3, -std::numeric_limits<double>::infinity(), kNaN}) {
    EXPECT_NEAR(gated({0.2, 0.4}, kSquash, margin_m, parameters).speed_mps, 0.04, 1e-15);
    EXPECT_NEAR(gated({0.1, 0.0}, kSquash, margin_m, parameters).speed_mps, 0.02, 1e-15);
  }
}

TEST(SpeedGate, WithoutCreepItIsTheLawAsPrinted) {
  const PolicyParameters parameters = creeping_at(0.0);
  const Command halted = gated({0.2, 0.4}, kSquash, -0.01, parameters);
  EXPECT_EQ(halted.speed_mps, 0.0);
  EXPECT_EQ(halted.yaw_rate_rps, 0.0);
  EXPECT_NEAR(gated({0.2, 0.0}, kSquash, 0.1, parameters).speed_mps, 0.15, 1e-15);
}

TEST(SpeedGate, LeavesReversingAndTurningOnTheSpot) {
  const PolicyParameters parameters = creeping_at(0.04);
  const Command back = gated({-0.1, 0.2}, kSquash, -1.0, parameters);
  EXPECT_EQ(back.speed_mps, -0.1);
  EXPECT_EQ(back.yaw_rate_rps, 0.2);
  EXPECT_EQ(gated({0.0, 0.6}, kSquash, 0.5, parameters).yaw_rate_rps, 0.6);
}

TEST(SpeedGate, IsMonotoneAndKeepsCurvatureAndBounds) {
  const PolicyParameters parameters = creeping_at(0.04);
  double last = 0.0;
  for (int i = -50; i < 200; ++i) {
    const Command command = gated({0.2, 0.55}, kSquash, 0.01 * i, parameters);
    EXPECT_LE(std::abs(command.yaw_rate_rps), 0.6);
    EXPECT_LE(command.speed_mps, 0.22);
    EXPECT_NEAR(command.yaw_rate_rps, 2.75 * command.speed_mps, 1e-15);
    EXPECT_GE(command.speed_mps, last - 1e-15);
    last = command.speed_mps;
  }
}

struct Guarded {
  Command step(double granted_mps) {
    GuardedTick tick;
    tick.speed_mps = granted_mps;
    tick.retreat_speed_mps = 0.08;
    const Command command = drive.step({0.2, 0.0}, tick, pose);
    pose.position.x_m += 0.02 * command.speed_mps;
    return command;
  }

  GuardedDrive drive{creeping_at(0.04), 0.02};
  Pose pose;
};

TEST(GuardedDrive, FollowsWhileTheGuardsGrantASpeed) {
  Guarded run;
  EXPECT_NEAR(run.step(0.15).speed_mps, 0.15, 1e-15);
  EXPECT_EQ(run.drive.retreats(), 0U);
}

TEST(GuardedDrive, HaltsRetreatsAndCreepsOn) {
  Guarded run;
  int halted = 0;
  Command command = run.step(0.0);
  for (; command.speed_mps == 0.0; command = run.step(0.0)) {
    ++halted;
  }
  EXPECT_EQ(halted, 15);  // 0.3 s
  for (; command.speed_mps < 0.0; command = run.step(0.0)) {
    EXPECT_EQ(command.speed_mps, -0.08);
    EXPECT_FALSE(run.drive.replans());
  }
  EXPECT_TRUE(run.drive.replans());
  EXPECT_EQ(run.drive.retreats(), 1U);
  EXPECT_NEAR(run.pose.position.x_m, -0.15, 0.004);
  // On at the creep until half a metre from where it was halted, and halted there again.
  double furthest_m = run.pose.position.x_m;
  while (command.speed_mps > 0.0) {
    EXPECT_NEAR(command.speed_mps, 0.04, 1e-15);
    furthest_m = run.pose.position.x_m;
    command = run.step(0.0);
    EXPECT_FALSE(run.drive.replans());
  }
  EXPECT_NEAR(furthest_m, 0.5, 0.002);
}

TEST(GuardedDrive, GoesOnAtWhatIsGrantedOnceMarginIsBack) {
  Guarded run;
  while (run.drive.retreats() == 0) {
    run.step(0.0);
  }
  EXPECT_NEAR(run.step(0.15).speed_mps, 0.15, 1e-15);
}

TEST(GuardedDrive, DoesNotRefuseToReverse) {
  Guarded run;
  GuardedTick tick;
  tick.retreat_speed_mps = 0.08;
  EXPECT_EQ(run.drive.step({-0.1, 0.2}, tick, run.pose).speed_mps, -0.1);
  EXPECT_EQ(run.drive.retreats(), 0U);
}

TEST(GuardedDrive, ARetreatEndsThoughTheBodyIsHeld) {
  Guarded run;
  int steps = 0;
  while (run.drive.retreats() == 0 && steps < 10'000) {
    run.step(0.0);
    run.pose = {};
    ++steps;
  }
  // 0.3 s, twice 0.15 m at 0.08 m/s and a second.
  EXPECT_NEAR(0.02 * steps, 0.3 + 3.75 + 1.0, 0.1);
  run.drive.reset();
  EXPECT_EQ(run.drive.retreats(), 0U);
}

}  // namespace
}  // namespace tcert::policies
