#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>
#include <tcert/guards.hpp>

#include "support/allocations.hpp"

namespace tcert {
namespace {

constexpr SpeedLaw kSquash{SpeedLawKind::squash, 0.08, 0.22, 10.0};
constexpr SpeedLaw kClip{SpeedLawKind::clip, 0.08, 0.22, 10.0};

// 0.1 m per m/s and 0.01 m per m/s^2, so that the algebra can be done by hand.
TrackingErrorTable steep_table() {
  return TrackingErrorTable({{0.0, 1.0}, {0.0, 10.0}, {0.0}, {0.0, 0.1, 0.1, 0.2}});
}

// Feeds ticks of 100 ms.
struct Loop {
  explicit Loop(const SpeedLaw& law, const GuardParameters& parameters = {})
      : guards(law, parameters, steep_table()) {}

  GuardedTick step(double margin_m, double corridor_value_m, double force_n = kMissing) {
    const std::array<RayReading, 2> rays{{{0.4, kMissing}, {0.4, force_n}}};
    const Tick tick{time_ns, {}, rays, false, false};
    CertifiedTick certified;
    certified.margin_m = margin_m;
    certified.corridor_value_m = corridor_value_m;
    certified.flags = flags;
    time_ns += 100'000'000;
    return guards.update(tick, certified);
  }

  Guards guards;
  std::int64_t time_ns = 0;
  std::uint32_t flags = 0;
};

TEST(Guards, TheBoundIsThatOfTheSpeedBefore) {
  Loop loop(kClip);
  // At rest r_TE = 0; V_rob = 0.05 is half way to 1/beta: 0.15 m/s.
  const GuardedTick first = loop.step(0.3, 0.05);
  EXPECT_EQ(first.tracking_error_m, 0.0);
  EXPECT_EQ(first.robust_margin_m, 0.05);
  EXPECT_NEAR(first.speed_mps, 0.15, 1e-15);
  // The first command has no change of speed: r_TE = 0.1 s * 0.15.
  const GuardedTick second = loop.step(0.3, 0.05);
  EXPECT_NEAR(second.tracking_error_m, 0.015, 1e-15);
  EXPECT_NEAR(second.robust_margin_m, 0.035, 1e-15);
  EXPECT_NEAR(second.speed_mps, 0.08 + 0.14 * 0.35, 1e-15);
  // 0.129 after 0.15: 0.21 m/s^2 more, 0.0021 m.
  const GuardedTick third = loop.step(0.3, 0.05);
  EXPECT_NEAR(third.tracking_error_m, 0.0129 + 0.0021, 1e-15);
}

TEST(Guards, SquashGoesByTheTickMargin) {
  Loop loop(kSquash);
  EXPECT_NEAR(loop.step(0.1, 0.02).speed_mps, 0.15, 1e-15);
  const GuardedTick none = loop.step(0.0, 0.5);
  EXPECT_TRUE(none.halted());
  EXPECT_EQ(none.triggers, guard_margin);
  EXPECT_EQ(none.retreat_speed_mps, 0.08);
}

TEST(Guards, ReplanTripsAtItsMarginAndIsSaidOnce) {
  Loop loop(kClip, {GuardMode::act, 0.02, 5.0, 50.0, 0.0});
  const GuardedTick tripped = loop.step(0.3, 0.02);
  EXPECT_TRUE(tripped.halted());
  EXPECT_EQ(tripped.triggers, guard_replan);
  EXPECT_EQ(tripped.began, guard_replan);
  const GuardedTick still = loop.step(0.3, 0.01);
  EXPECT_EQ(still.triggers, guard_replan);
  EXPECT_EQ(still.began, 0U);
  const GuardedTick free = loop.step(0.3, 0.021);
  EXPECT_FALSE(free.halted());
  EXPECT_EQ(free.triggers, 0U);
  EXPECT_EQ(free.ended, guard_replan);
}

TEST(Guards, WatchingChangesNoSpeed) {
  Loop acting(kClip, {GuardMode::act, 0.02, 5.0, 50.0, 0.0});
  Loop watching(kClip, {GuardMode::watch, 0.02, 5.0, 50.0, 0.0});
  EXPECT_EQ(acting.step(0.3, 0.01).speed_mps, 0.0);
  const GuardedTick watched = watching.step(0.3, 0.01);
  EXPECT_EQ(watched.triggers, guard_replan);
  EXPECT_NEAR(watched.speed_mps, 0.08 + 0.14 * 0.1, 1e-15);
}

TEST(Guards, ByTheLawClipActsAndSquashWatches) {
  Loop clip(kClip);
  Loop squash(kSquash);
  EXPECT_TRUE(clip.step(0.3, 0.0).halted());
  const GuardedTick watched = squash.step(0.3, 0.0);
  EXPECT_EQ(watched.triggers, guard_replan);
  EXPECT_FALSE(watched.halted());
}

TEST(Guards, TheForceLimitGrowsWithTheMargin) {
  Loop loop(kClip, {GuardMode::act, 0.005, 5.0, 50.0, 0.0});
  // F_max = 5 + 50 * 0.04 = 7 N.
  const GuardedTick pressed = loop.step(0.3, 0.04, 7.5);
  EXPECT_NEAR(pressed.force_limit_n, 7.0, 1e-12);
  EXPECT_EQ(pressed.force_n, 7.5);
  EXPECT_EQ(pressed.triggers, guard_force);
  EXPECT_TRUE(pressed.halted());
  EXPECT_EQ(loop.step(0.3, 0.06, 7.5).triggers, 0U);
  EXPECT_NEAR(loop.step(0.3, -0.5, 1.0).force_limit_n, 5.0, 1e-12);
}

TEST(Guards, WithoutEvidenceThereIsNoForwardMotion) {
  Loop loop(kSquash);
  loop.step(0.3, 0.3);
  loop.flags = flag_stale;
  const GuardedTick blind = loop.step(0.3, 0.3);
  EXPECT_EQ(blind.triggers, guard_no_evidence);
  EXPECT_TRUE(blind.halted());
  EXPECT_TRUE(std::isnan(blind.robust_margin_m));
}

TEST(Guards, WithoutABoundOrACorridorThereIsNoRobustMargin) {
  Loop loop(kSquash, {GuardMode::act, 0.005, 5.0, 50.0, 1.0});
  const GuardedTick unbounded = loop.step(0.3, 0.3);
  EXPECT_EQ(unbounded.triggers, guard_replan | guard_no_bound) << "disturbance 1 is off the table";
  Loop outside(kSquash);
  EXPECT_EQ(outside.step(0.3, -std::numeric_limits<double>::infinity()).triggers, guard_replan);
}

TEST(Guards, ResetForgetsTheRun) {
  Loop loop(kClip);
  const GuardedTick first = loop.step(0.3, 0.05);
  loop.step(0.3, 0.0);
  loop.guards.reset();
  const GuardedTick again = loop.step(0.3, 0.05);
  EXPECT_EQ(again.speed_mps, first.speed_mps);
  EXPECT_EQ(again.tracking_error_m, 0.0);
  EXPECT_EQ(again.ended, 0U);
}

TEST(Guards, AllocateNothing) {
  Loop loop(kClip);
  const std::size_t before = test_support::allocation_count();
  for (int i = 0; i < 1000; ++i) {
    loop.step(0.001 * i, 0.0005 * i, 0.01 * i);
  }
  EXPECT_EQ(test_support::allocation_count(), before);
}

TEST(Guards, RefuseImpossibleParameters) {
  EXPECT_THROW(validate(GuardParameters{GuardMode::act, 0.0, 0.0, 50.0, 0.0}),
               std::invalid_argument);
  EXPECT_THROW(validate(GuardParameters{GuardMode::act, 0.0, 5.0, -1.0, 0.0}),
               std::invalid_argument);
  EXPECT_THROW(validate(GuardParameters{GuardMode::act, 0.0, 5.0, 50.0, -1.0}),
               std::invalid_argument);
}

}  // namespace
}  // namespace tcert
