#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <tcert/fallback.hpp>

namespace tcert {
namespace {

// A body that does at once what it is told, at 10 Hz.
struct Driven {
  explicit Driven(double min_turn_radius_m = 0.0) : fallback({}, min_turn_radius_m) {}

  FallbackState step(bool alarm, double wanted_mps = 0.2, int side = 1) {
    command = fallback.step({wanted_mps, 0.0}, alarm, pose, side, 0.1);
    pose.yaw_rad += 0.1 * command.yaw_rate_rps;
    pose.position = pose.position + 0.1 * command.speed_mps * direction(pose.yaw_rad);
    time_s += 0.1;
    return fallback.state();
  }
  void run_until_normal() {
    for (int i = 0; i < 1000 && fallback.state() != FallbackState::normal; ++i) {
      step(false);
    }
  }

  Fallback fallback;
  Pose pose;
  Command command;
  double time_s = 0.0;
};

TEST(Fallback, StopsReversesAndReOrientsToTheWiderSide) {
  Driven driven;
  EXPECT_EQ(driven.step(false), FallbackState::normal);
  EXPECT_EQ(driven.command.speed_mps, 0.2) << "without an alarm what is wanted stands";
  const double x_m = driven.pose.position.x_m;
  EXPECT_EQ(driven.step(true, 0.2, -1), FallbackState::stop);
  double stopped_s = 0.1;
  while (driven.step(true) == FallbackState::stop) {
    stopped_s += 0.1;
  }
  EXPECT_NEAR(stopped_s, 0.3, 1e-9);
  EXPECT_EQ(driven.fallback.state(), FallbackState::reverse);
  driven.run_until_normal();
  const double on_m = 0.02 * std::cos(driven.pose.yaw_rad);  // of the step that is normal again
  EXPECT_NEAR(x_m - driven.pose.position.x_m, 0.15 - on_m, 0.011);
  EXPECT_NEAR(driven.pose.yaw_rad, -0.5236, 0.061) << "to the right";
  EXPECT_EQ(driven.fallback.manoeuvres(), 1U);
  EXPECT_LT(driven.time_s, 8.0);
}

TEST(Fallback, HaltsForGoodAfterThreeWithinHalfAMinute) {
  Driven driven;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(driven.step(true), FallbackState::stop) << i;
    driven.run_until_normal();
  }
  EXPECT_EQ(driven.step(true), FallbackState::halt);
  EXPECT_EQ(driven.command.speed_mps, 0.0);
  for (int i = 0; i < 1000; ++i) {
    driven.step(false);
  }
  EXPECT_EQ(driven.fallback.state(), FallbackState::halt);
  driven.fallback.reset();
  EXPECT_EQ(driven.step(false), FallbackState::normal);
}

TEST(Fallback, GoesOnWhereAlarmsAreFarApart) {
  Driven driven;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(driven.step(true), FallbackState::stop) << i;
    driven.run_until_normal();
    while (driven.time_s < 11.0 * (i + 1)) {
      driven.step(false);
    }
  }
  EXPECT_EQ(driven.fallback.manoeuvres(), 10U);
}

TEST(Fallback, DoesNotRefuseToReverseAndTurnsOnItsRadius) {
  Driven driven(0.35);
  EXPECT_EQ(driven.step(true, -0.1), FallbackState::normal);
  EXPECT_EQ(driven.command.speed_mps, -0.1);
  driven.step(true);
  while (driven.fallback.state() != FallbackState::reorient) {
    driven.step(false);
  }
  driven.step(false);
  EXPECT_LT(driven.command.speed_mps, 0.0);
  EXPECT_GE(std::abs(driven.command.speed_mps),
            0.35 * std::abs(driven.command.yaw_rate_rps) - 1e-12);
}

TEST(Fallback, RefusesParametersOutOfRange) {
  FallbackParameters parameters;
  parameters.halt_after = 0;
  EXPECT_THROW(Fallback(parameters, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace tcert
