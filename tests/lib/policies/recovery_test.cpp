#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tcert/recovery.hpp>

namespace tcert::policies {
namespace {

constexpr double kPeriod = 0.02;
constexpr double kPi = std::numbers::pi;
const Pressure kNone{};

// A body that does at once what it is told.
struct Driven {
  explicit Driven(double min_turn_radius_m = 0.0, const PolicyParameters& parameters = {})
      : recovery(parameters, min_turn_radius_m, kPeriod) {}

  std::optional<Command> step(const Pressure& pressure, double forward_mps, int freer_side = 1) {
    const auto command = recovery.step(pose, pressure, freer_side, forward_mps);
    if (command) {
      pose.yaw_rad += kPeriod * command->yaw_rate_rps;
      pose.position = pose.position + kPeriod * command->speed_mps * direction(pose.yaw_rad);
    }
    return command;
  }
  void advance(double way_m) { pose.position.x_m += way_m; }

  // Steps until the recovery is over; how many it took.
  int until_over(int freer_side = 1) {
    int steps = 0;
    while (step(kNone, 0.0, freer_side) && steps < 10'000) {
      ++steps;
    }
    return steps;
  }

  Recovery recovery;
  Pose pose;
};

Pressure frontal(double force_n) { return {force_n, std::nullopt}; }
Pressure bumped(double bearing_rad, double force_n) {
  return {kMissing, Bump{bearing_rad, force_n}};
}

TEST(Recovery, StopsReversesAndReOrients) {
  Driven driven;
  ASSERT_FALSE(driven.step(kNone, 0.17));
  const auto first = driven.step(frontal(41.0), 0.17, -1);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->speed_mps, 0.0);
  int standing = 1;
  auto command = driven.step(kNone, 0.0);
  for (; command && command->speed_mps == 0.0 && command->yaw_rate_rps == 0.0;
       command = driven.step(kNone, 0.0)) {
    ++standing;
  }
  EXPECT_EQ(standing, 15);  // 0.3 s
  for (; command && command->speed_mps < 0.0; command = driven.step(kNone, 0.0)) {
    EXPECT_EQ(command->yaw_rate_rps, 0.0);
  }
  EXPECT_NEAR(driven.pose.position.x_m, -0.15, 0.1 * kPeriod + 1e-9);
  while (command) {
    EXPECT_EQ(command->speed_mps, 0.0);
    EXPECT_LT(command->yaw_rate_rps, 0.0) << "to the freer side";
    command = driven.step(kNone, 0.0);
  }
  EXPECT_NEAR(driven.pose.yaw_rad, -kPi / 6.0, 0.6 * kPeriod + 1e-9);
  ASSERT_TRUE(driven.recovery.held_turn(driven.pose));
  EXPECT_NEAR(*driven.recovery.held_turn(driven.pose), 0.0, 0.6 * kPeriod + 1e-9);
  for (int i = 0; i < 38; ++i) {  // 0.75 s are 37.5 periods
    EXPECT_TRUE(driven.recovery.held_turn(driven.pose)) << i;
    ASSERT_FALSE(driven.step(kNone, 0.0));
  }
  EXPECT_FALSE(driven.recovery.held_turn(driven.pose));
}

TEST(Recovery, KeepsTheTurnRadiusInReverse) {
  Driven driven(0.35);
  ASSERT_TRUE(driven.step(frontal(41.0), 0.17));
  double turned_rad = 0.0;
  while (const auto command = driven.step(kNone, 0.0)) {
    ASSERT_GE(std::abs(command->speed_mps) + 1e-12, 0.35 * std::abs(command->yaw_rate_rps));
    turned_rad += kPeriod * command->yaw_rate_rps;
  }
  EXPECT_NEAR(turned_rad, kPi / 6.0, 0.3 * kPeriod);
}

TEST(Recovery, TurnsAwayFromTheBump) {
  for (const double bearing_rad : {0.4, -0.4}) {
    Driven driven;
    ASSERT_TRUE(driven.step(bumped(bearing_rad, 60.0), 0.17, bearing_rad > 0.0 ? 1 : -1));
    driven.until_over();
    EXPECT_LT(driven.pose.yaw_rad * bearing_rad, 0.0);
  }
}

TEST(Recovery, SlidingAlongIsNoReason) {
  Driven driven;
  EXPECT_FALSE(driven.step(bumped(1.2, 60.0), 0.17)) << "not frontal";
  EXPECT_FALSE(driven.step(bumped(0.0, 40.0), 0.17)) << "not above F_stop";
  EXPECT_FALSE(driven.step(frontal(kMissing), 0.17));
  EXPECT_TRUE(driven.step(bumped(1.0, 60.0), 0.17));
}

TEST(Recovery, BeginsWhereForwardCommandsLeadNowhere) {
  Driven driven;
  int steps = 0;
  while (!driven.step(kNone, 0.1)) {
    ++steps;
  }
  EXPECT_NEAR(steps * kPeriod * 0.1, 0.15, 2.0 * kPeriod * 0.1);
  Driven moves;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_FALSE(moves.step(kNone, 0.1));
    moves.advance(0.02 * kPeriod);  // a fifth of what is commanded
  }
  Driven halted;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_FALSE(halted.step(kNone, 0.0)) << "a robot that is told to stand is not stuck";
  }
}

TEST(Recovery, CountsWhatFailsAtOnePlaceAndGivesUp) {
  PolicyParameters parameters;
  parameters.give_up_after = 2;
  Driven driven(0.0, parameters);
  for (std::uint32_t n = 0; n < 6; ++n) {
    ASSERT_TRUE(driven.step(frontal(41.0), 0.17));
    EXPECT_EQ(driven.recovery.failed(), n);
    EXPECT_EQ(driven.recovery.gives_up(), n == 2 || n == 4);
    driven.step(kNone, 0.0);
    EXPECT_FALSE(driven.recovery.gives_up()) << "in one step";
    driven.until_over();
    driven.pose = {};  // back at the obstacle
  }
  driven.advance(0.6);
  ASSERT_FALSE(driven.step(kNone, 0.17));
  EXPECT_EQ(driven.recovery.failed(), 0U);
  ASSERT_TRUE(driven.step(frontal(41.0), 0.17));
  EXPECT_EQ(driven.recovery.failed(), 0U) << "another place";
}

TEST(Recovery, DoesNotReverseForEver) {
  Driven held;
  ASSERT_TRUE(held.step(frontal(41.0), 0.17));
  int steps = 0;
  while (held.recovery.step({}, kNone, 1, 0.0) && steps < 10'000) {
    ++steps;  // the body stays where it is
  }
  // 0.3 s, twice 1.5 s and a second, twice 0.87 s and a second.
  EXPECT_NEAR(steps * kPeriod, 0.3 + 4.0 + 2.75, 0.1);
  Driven behind;
  ASSERT_TRUE(behind.step(frontal(41.0), 0.17));
  for (int i = 0; i < 20; ++i) {
    behind.step(kNone, 0.0);
  }
  EXPECT_EQ(behind.step(bumped(kPi, 60.0), 0.0)->speed_mps, 0.0) << "something is behind";
}

}  // namespace
}  // namespace tcert::policies
