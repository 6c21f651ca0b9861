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

Robot robot_of_test() {
  Robot robot;
  robot.rays = {{"left", {0.2, 0.1}, 1.57, 0.6, RayKind::range, {}},
                {"right", {0.2, -0.1}, -1.57, 0.6, RayKind::range, {}}};
  return robot;
}

// r_TE is then taken off once, so that the algebra is that of the table.
CertificateParameters radial() {
  CertificateParameters parameters;
  parameters.clearance = ClearanceReading::radial;
  return parameters;
}

// Feeds ticks of 100 ms.
struct Loop {
  explicit Loop(const SpeedLaw& law, const GuardParameters& parameters = {})
      : guards({robot_of_test(), radial(), law, parameters, steep_table()}) {}

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

TEST(Guards, TheSpeedIsOneThatItsOwnBoundAllows) {
  Loop loop(kClip);
  // A first command has no change of speed: v = 0.08 + 1.4 (0.05 - 0.1 v).
  const GuardedTick first = loop.step(0.3, 0.05);
  EXPECT_NEAR(first.speed_mps, 0.15 / 1.14, 1e-9);
  EXPECT_NEAR(first.tracking_error_m, 0.1 * first.speed_mps, 1e-12);
  EXPECT_NEAR(first.robust_margin_m, 0.05 - first.tracking_error_m, 1e-15);
  EXPECT_NEAR(loop.step(0.3, 0.05).speed_mps, first.speed_mps, 1e-9) << "and it stays";
  // After a halt the change counts, too: v = 0.08 + 1.4 (0.05 - 0.1 v - 0.01 v / 0.1).
  EXPECT_TRUE(loop.step(0.3, 0.0).halted());
  EXPECT_NEAR(loop.step(0.3, 0.05).speed_mps, 0.15 / 1.28, 1e-9);
}

TEST(Guards, OffAWidthTheBoundIsTakenTwice) {
  Guards guards({robot_of_test(), {}, kClip, {}, steep_table()});
  const std::array<RayReading, 2> rays{{{0.4, kMissing}, {0.4, kMissing}}};
  CertifiedTick certified;
  certified.corridor_value_m = 0.05;
  const GuardedTick now = guards.update({0, {}, rays, false, false}, certified);
  EXPECT_NEAR(now.speed_mps, 0.15 / 1.28, 1e-9);
  EXPECT_NEAR(now.robust_margin_m, 0.05 - 0.2 * now.speed_mps, 1e-12);
}

// Where r_TE were that of the speed before, V = 0.02 would halt and go at every other tick.
TEST(Guards, AConstantMarginMakesNoChatter) {
  const auto switches = [](auto next_speed) {
    int count = 0;
    double last = -1.0;
    for (int i = 0; i < 200; ++i) {
      const double speed = next_speed();
      count += i > 0 && (speed == 0.0) != (last == 0.0) ? 1 : 0;
      last = speed;
    }
    return count;
  };
  int most_before = 0;
  for (double value_m = 0.0; value_m < 0.15; value_m += 0.001) {
    Loop loop(kClip, {GuardMode::act, 0.005, 5.0, 50.0, 0.0});
    EXPECT_EQ(switches([&] { return loop.step(0.3, value_m).speed_mps; }), 0) << value_m;
    double last = 0.0;
    double change = 0.0;
    most_before =
        std::max(most_before, switches([&] {
                   const double robust_m = value_m - steep_table().radius_m(last, change, 0.0);
                   const double speed = robust_m > 0.005 ? gated_speed(kClip, robust_m) : 0.0;
                   change = std::abs(speed - last) / 0.1;
                   last = speed;
                   return speed;
                 }));
  }
  EXPECT_GT(most_before, 60) << "what it cures";
}

// v = law(V - r_TE(v)): of clip some v solves it for every V, of squash for some V none does.
TEST(Guards, OnlyTheClipLawAlwaysHasAFixedPoint) {
  const TrackingErrorTable table = steep_table();
  const auto nearest_miss = [&](const SpeedLaw& law, double value_m) {
    double least = 1.0;
    for (double v = 0.0; v <= 0.22; v += 1e-4) {
      const double margin_m = value_m - table.radius_m(v, 0.0, 0.0);
      least = std::min(least, std::abs(v - gated_speed(law, margin_m)));
    }
    return least;
  };
  for (double value_m = -0.05; value_m < 0.3; value_m += 0.001) {
    EXPECT_LT(nearest_miss(kClip, value_m), 2e-4) << value_m;
  }
  EXPECT_GT(nearest_miss(kSquash, 0.004), 0.03) << "0 is too little, v_min too much";
}

TEST(Guards, ASpeedJustLeftGoesOnCounting) {
  TrackingErrorGrid grid{{0.0, 0.3}, {}, {0.0}, {0.0, 0.09, 0.09, 0.09}};
  grid.speed_left_mps = {0.0, 0.3};
  grid.hold_s = {0.0, 0.3};
  Guards guards({robot_of_test(), radial(), kClip, {}, TrackingErrorTable(grid)});
  const std::array<RayReading, 2> rays{{{0.4, kMissing}, {0.4, kMissing}}};
  std::int64_t time_ns = 0;
  const auto step = [&](double value_m) {
    CertifiedTick certified;
    certified.corridor_value_m = value_m;
    time_ns += 100'000'000;
    return guards.update({time_ns, {}, rays, false, false}, certified);
  };
  const GuardedTick fast = step(1.0);
  EXPECT_EQ(fast.speed_mps, 0.22);
  EXPECT_TRUE(step(0.0).halted());
  // 0.22 m/s counts for 0.22 s: two ticks later it still does, three later no more.
  EXPECT_NEAR(step(0.0).tracking_error_m, 0.0722, 1e-3);
  EXPECT_NEAR(step(0.0).tracking_error_m, 0.0722, 1e-3);
  EXPECT_NEAR(step(0.0).tracking_error_m, 0.09 * (0.08 / 0.3) * 2.0 - 0.09 * 0.0711, 1e-3);
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
  const GuardedTick free = loop.step(0.3, 0.04);
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
  EXPECT_NEAR(watched.speed_mps, (0.08 + 1.4 * 0.01) / 1.14, 1e-9);
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
  // v = (0.08 + 1.4 * 0.04) / 1.14, F_max = 5 + 50 (0.04 - 0.1 v).
  const GuardedTick pressed = loop.step(0.3, 0.04, 7.5);
  EXPECT_NEAR(pressed.force_limit_n, 5.0 + 50.0 * (0.04 - 0.1 * 0.136 / 1.14), 1e-6);
  EXPECT_EQ(pressed.force_n, 7.5);
  EXPECT_EQ(pressed.triggers, guard_force);
  EXPECT_TRUE(pressed.halted());
  EXPECT_EQ(loop.step(0.3, 0.09, 7.5).triggers, 0U);
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
  EXPECT_EQ(again.tracking_error_m, first.tracking_error_m);
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

// A real clock counts nanoseconds since 1970: only differences may matter.
TEST(Guards, AreTheSameAtAnotherTime) {
  const auto granted = [](std::int64_t since_ns) {
    std::vector<GuardedTick> all;
    for (const SpeedLaw& law : {kClip, kSquash}) {
      Loop loop(law);
      loop.time_ns = since_ns;
      for (int k = 0; k < 60; ++k) {
        loop.time_ns += k % 7 == 0 ? 40'000'000 : 0;
        all.push_back(loop.step(0.01 * (k % 23), 0.2 - 0.013 * (k % 17), 0.4 * (k % 11)));
      }
    }
    return all;
  };
  const auto plain = granted(0);
  for (const std::int64_t since_ns : {std::int64_t{1'700'000'000'123'456'789}, std::int64_t{-5}}) {
    const auto later = granted(since_ns);
    for (std::size_t k = 0; k < plain.size(); ++k) {
      ASSERT_EQ(plain[k].speed_mps, later[k].speed_mps) << k;
      ASSERT_EQ(plain[k].tracking_error_m, later[k].tracking_error_m) << k;
      ASSERT_EQ(plain[k].robust_margin_m, later[k].robust_margin_m) << k;
      ASSERT_EQ(plain[k].triggers, later[k].triggers) << k;
    }
  }
}

}  // namespace
}  // namespace tcert
