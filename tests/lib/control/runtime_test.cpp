#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <tcert/runtime.hpp>

#include "support/allocations.hpp"
#include "support/random_run.hpp"

namespace tcert {
namespace {

using test_support::random_run;

ActionSetup everything(const Robot& robot, SpeedLawKind law) {
  ActionSetup setup;
  setup.guards = {robot, {}, {}, {}, TrackingErrorTable()};
  setup.guards.law.kind = law;
  setup.risk.emplace();
  setup.rules = parse_rules(default_rules());
  return setup;
}

TEST(Runtime, IsItsPartsInTheirOrderAndAllocatesNothing) {
  for (const SpeedLawKind law :
       {SpeedLawKind::squash, SpeedLawKind::clip, SpeedLawKind::barrier, SpeedLawKind::profile}) {
    const test_support::Run run = random_run(static_cast<std::uint32_t>(law), 500);
    Runtime runtime(run.course, everything(run.robot, law));
    Certifier certifier(run.robot, run.course, {});
    TickActions actions(everything(run.robot, law));
    for (int pass = 0; pass < 2; ++pass) {
      for (const Tick& tick : run.ticks) {
        const std::size_t before = test_support::allocation_count();
        const RuntimeTick now = runtime.update(tick, {0.1, 0.05});
        const Command next = runtime.step({0.2, 0.1}, tick.pose, 0.1);
        ASSERT_EQ(test_support::allocation_count(), before);
        const CertifiedTick certified = certifier.update(tick);
        const ActedTick acted = actions.update(tick, certified, {0.1, 0.05});
        const Command expected = actions.step({0.2, 0.1}, tick.pose, 0.1);
        ASSERT_EQ(now.acted.guarded.speed_mps, acted.guarded.speed_mps);
        ASSERT_EQ(now.acted.alarms, acted.alarms);
        ASSERT_EQ(next.speed_mps, expected.speed_mps);
        const bool known = (certified.flags & (flag_stale | flag_bad_input)) == 0;
        ASSERT_EQ(!std::isnan(now.acted.risk_ahead), known);
        ASSERT_FALSE(known && (now.acted.risk_ahead < 0.0 || now.acted.risk_ahead > 1.0));
        ASSERT_GE(now.acted.guarded.speed_mps, 0.0);
        ASSERT_LE(now.acted.guarded.speed_mps, 0.22);
      }
      runtime.reset();
      certifier.reset();
      actions.reset();
    }
  }
}

TEST(Runtime, AnAlarmBacksOut) {
  const test_support::Run run = random_run(3, 200);
  ActionSetup setup = everything(run.robot, SpeedLawKind::squash);
  setup.rules = parse_rules("always: time_s >= 0");
  Runtime runtime(run.course, setup);
  const RuntimeTick now = runtime.update(run.ticks.front(), {0.1, 0.0});
  EXPECT_EQ(now.acted.alarms, 1U);
  EXPECT_EQ(now.acted.alarms_began, 1U);
  EXPECT_EQ(runtime.step({0.2, 0.0}, run.ticks.front().pose, 0.1).speed_mps, 0.0);
  EXPECT_EQ(runtime.actions().fallback().state(), FallbackState::stop);
  EXPECT_EQ(runtime.update(run.ticks[1], {0.0, 0.0}).acted.alarms_began, 0U);
  setup.rules = parse_rules("watch always: time_s >= 0");
  Runtime watching(run.course, setup);
  EXPECT_EQ(watching.update(run.ticks.front(), {0.1, 0.0}).acted.alarms, 1U);
  EXPECT_EQ(watching.step({0.2, 0.0}, run.ticks.front().pose, 0.1).speed_mps, 0.2);
}

TEST(Runtime, TheRiskAheadFallsWhereTheBodyHasBeen) {
  const test_support::Run run = random_run(5, 10);
  Runtime runtime(run.course, everything(run.robot, SpeedLawKind::squash));
  std::vector<RayReading> rays(run.robot.rays.size());
  double first = 0.0;
  double again = 0.0;
  for (int lap = 0; lap < 2; ++lap) {
    for (int i = 0; i < 60; ++i) {
      const Tick tick{
          (lap * 100 + i) * std::int64_t{100'000'000}, {{0.02 * i, 0.0}, 0.0}, rays, false, false};
      (lap == 0 ? first : again) = runtime.update(tick).acted.risk_ahead;
      if (i == 20) {
        break;
      }
    }
    for (int i = 20; i < 60 && lap == 0; ++i) {
      runtime.update(
          {(50 + i) * std::int64_t{100'000'000}, {{0.02 * i, 0.0}, 0.0}, rays, false, false});
    }
  }
  EXPECT_GT(first, 0.3) << "nobody has been there";
  EXPECT_LT(again, 0.5 * first);
}

// A tick that is refused says nothing, whatever its time is.
TEST(Runtime, ABadTickLoosensNothing) {
  const test_support::Run run = random_run(7, 300);
  for (const SpeedLawKind law : {SpeedLawKind::clip, SpeedLawKind::profile}) {
    Runtime with(run.course, everything(run.robot, law));
    Runtime without(run.course, everything(run.robot, law));
    for (std::size_t i = 0; i < run.ticks.size(); ++i) {
      if (i % 40 == 0) {
        Tick bad = run.ticks[i];
        bad.time_ns = i % 80 == 0 ? -5'000'000'000 : 9'000'000'000'000'000'000;
        bad.rays = {};
        const RuntimeTick refused = with.update(bad, {0.1, 0.0});
        ASSERT_TRUE(refused.acted.guarded.halted());
      }
      const RuntimeTick a = with.update(run.ticks[i], {0.1, 0.0});
      const RuntimeTick b = without.update(run.ticks[i], {0.1, 0.0});
      ASSERT_LE(a.acted.guarded.speed_mps, b.acted.guarded.speed_mps + 1e-12) << i;
      ASSERT_EQ(std::isnan(a.acted.risk_ahead), std::isnan(b.acted.risk_ahead));
      if (!std::isnan(a.acted.risk_ahead)) {
        ASSERT_EQ(a.acted.risk_ahead, b.acted.risk_ahead) << i;
      }
    }
  }
}

TEST(Runtime, TheBarrierLawNeedsNoCommand) {
  const test_support::Run run = random_run(9, 20);
  Runtime runtime(run.course, everything(run.robot, SpeedLawKind::barrier));
  double fastest = 0.0;
  for (const Tick& tick : run.ticks) {
    fastest = std::max(fastest, runtime.update(tick).acted.guarded.speed_mps);
  }
  EXPECT_GE(fastest, 0.0);
  EXPECT_EQ(runtime.step({kMissing, kMissing}, {}, 0.1).speed_mps, 0.0);
}

TEST(Runtime, RefusesAFieldOfTooManyCells) {
  const test_support::Run run = random_run(1, 10);
  ActionSetup setup = everything(run.robot, SpeedLawKind::squash);
  setup.risk->cell_m = 0.001;
  setup.risk->ahead_m = 50.0;
  EXPECT_THROW(TickActions{setup}, std::invalid_argument);
}

}  // namespace
}  // namespace tcert
