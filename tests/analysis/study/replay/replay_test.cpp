#include "analysis/study/replay/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tcert::study {
namespace {

constexpr std::int64_t kTickNs = 100'000'000;
constexpr SpeedLaw kSquash{SpeedLawKind::squash, 0.08, 0.22, 10.0};
constexpr SpeedLaw kClip{SpeedLawKind::clip, 0.08, 0.22, 10.0};

/// A run along +x, tick by tick; its margins are what the test says, not what rays felt.
struct LoggedRun {
  /// So many intervals of so much length; the margin is that of the first tick of each.
  void drive(int intervals, double step_m, double margin_m, double value_m = 0.5) {
    for (int i = 0; i < intervals; ++i) {
      add(margin_m, value_m);
      x_m += step_m;
    }
  }
  void add(double margin_m, double value_m) {
    ticks.time_ns.push_back(static_cast<std::int64_t>(ticks.size()) * kTickNs);
    ticks.poses.push_back({{x_m, 0.0}, 0.0});
    ticks.stale.push_back(0);
    ticks.segment_start.push_back(0);
    ticks.speed_cmd_mps.push_back(0.12);
    CertifiedTick tick;
    tick.time_ns = ticks.time_ns.back();
    tick.margin_m = margin_m;
    tick.corridor_value_m = value_m;
    series.push_back(tick);
  }
  /// The tick that ends the last interval.
  void end() { add(0.1, 0.5); }

  [[nodiscard]] Replay replayed(const SpeedLaw& law, const ReplayOptions& options = {}) const {
    TickActions actions(
        {{{}, {}, law, {}, TrackingErrorTable({{0.0, 10.0}, {0.0, 100.0}, {0.0}, {0, 0, 0, 0}})},
         {},
         {},
         {}});
    return replay(ticks, series, act_trial(actions, ticks, series), options);
  }

  TickTable ticks;
  std::vector<CertifiedTick> series;
  double x_m = 0.0;
};

// Speed without a window: of the interval itself.
constexpr ReplayOptions kOneTick{0.02, 0.1, 0.05};

/// Three segments by hand, at 0.12 m/s: 1.2 m with margin 0.1, 0.6 m without margin, 1.2 m with
/// margin 0.025.
LoggedRun three_segments() {
  LoggedRun run;
  run.drive(100, 0.012, 0.1);
  run.drive(50, 0.012, 0.0);
  run.drive(100, 0.012, 0.025);
  run.end();
  return run;
}

TEST(Replay, RetimesThreeSegmentsByTheSquashLaw) {
  const Replay found = three_segments().replayed(kSquash, kOneTick);
  EXPECT_NEAR(found.length_m, 3.0, 1e-12);
  EXPECT_NEAR(found.time_s, 25.0, 1e-12);
  // beta m = 1 gives 0.08 + 0.14 / 2; no margin creeps at 0.08; beta m = 1/4 gives 0.08 + 0.14 / 5.
  EXPECT_NEAR(found.gated_time_s, 1.2 / 0.15 + 0.6 / 0.08 + 1.2 / 0.108, 1e-9);
  EXPECT_EQ(found.stalls, 1U);
  EXPECT_NEAR(found.stall_m, 0.6, 1e-12);
  EXPECT_EQ(found.creep_m, 0.0);
  EXPECT_EQ(found.margin_trips, 1U);
  EXPECT_FALSE(keeps_success(found, {}));
  EXPECT_EQ(found.speed_cmd_mps, 0.12);
  // 8 s at 0.15, 7.5 s at 0.08, 11.1 s at 0.108: half of 26.6 s is at 0.108 or less.
  EXPECT_NEAR(found.gated_speed_cmd_mps.value(), 0.108, 1e-15);
  EXPECT_NEAR(rate_of_advance(found.length_m, found.time_s).value(), 7.2, 1e-9);
}

TEST(Replay, RetimesThreeSegmentsByTheClipLaw) {
  LoggedRun run;
  run.drive(100, 0.012, 0.3, 0.1);   // at the cap: 0.22
  run.drive(50, 0.012, 0.3, 0.0);    // at or below epsilon: G3 halts
  run.drive(100, 0.012, 0.3, 0.05);  // half way: 0.15
  run.end();
  const Replay found = run.replayed(kClip, kOneTick);
  EXPECT_NEAR(found.gated_time_s, 1.2 / 0.22 + 0.6 / 0.08 + 1.2 / 0.15, 1e-9);
  EXPECT_EQ(found.stalls, 1U);
  EXPECT_EQ(found.replan_trips, 1U);
  EXPECT_EQ(found.margin_trips, 0U);
}

TEST(Replay, AShortStretchIsCreptThrough) {
  LoggedRun run;
  run.drive(10, 0.012, 0.1);
  run.drive(4, 0.012, -0.01);  // 4.8 cm
  run.drive(10, 0.012, 0.1);
  run.drive(5, 0.010, -0.01);  // 5 cm
  run.drive(10, 0.012, 0.1);
  run.end();
  const Replay found = run.replayed(kSquash, kOneTick);
  EXPECT_EQ(found.stalls, 1U);
  EXPECT_NEAR(found.stall_m, 0.05, 1e-12);
  EXPECT_NEAR(found.creep_m, 0.048, 1e-12);
  EXPECT_NEAR(found.gated_time_s, 0.36 / 0.15 + 0.098 / 0.08, 1e-9);
}

TEST(Replay, StandingStillKeepsItsTimeAndCountsNoLength) {
  LoggedRun run;
  run.drive(10, 0.012, 0.1);
  // 3 s wedged, the pose going to and fro by 1.5 mm a tick: 15 mm/s.
  for (int i = 0; i < 30; ++i) {
    run.drive(1, i % 2 == 0 ? 0.0015 : -0.0015, -0.02);
  }
  run.end();
  const Replay found = run.replayed(kSquash, kOneTick);
  EXPECT_NEAR(found.length_m, 0.12, 1e-12);
  EXPECT_NEAR(found.slow_s, 3.0, 1e-12);
  EXPECT_NEAR(found.gated_time_s, 0.12 / 0.15 + 3.0, 1e-9);
  EXPECT_EQ(found.stalls, 0U);
}

TEST(Replay, PoseNoiseIsNoMotionOverAWindow) {
  LoggedRun run;
  // 4 mm a tick to and fro reads as 0.04 m/s from tick to tick, but as nothing over half a second.
  for (int i = 0; i < 60; ++i) {
    run.drive(1, i % 2 == 0 ? 0.004 : -0.004, 0.1);
  }
  run.end();
  EXPECT_GT(run.replayed(kSquash, kOneTick).length_m, 0.2);
  EXPECT_LT(run.replayed(kSquash).length_m, 0.05) << "but for the first half second";
}

TEST(Replay, ARetreatIsNoStall) {
  LoggedRun run;
  run.drive(10, 0.012, 0.1);
  run.drive(2, 0.012, -0.01);
  run.drive(20, -0.012, -0.01);
  run.end();
  const Replay found = run.replayed(kSquash, kOneTick);
  EXPECT_EQ(found.stalls, 0U);
  EXPECT_NEAR(found.creep_m, 0.024, 1e-12);
  EXPECT_NEAR(found.gated_time_s, 0.12 / 0.15 + 0.264 / 0.08, 1e-9);
}

TEST(Replay, EndsAtTheFirstTickInsideG) {
  LoggedRun run;
  run.drive(100, 0.012, 0.1);
  run.drive(50, 0.012, 0.1);
  run.end();
  run.series[100].flags = flag_goal_reached;
  const Replay found = run.replayed(kSquash, kOneTick);
  EXPECT_NEAR(found.length_m, 1.2, 1e-12);
  EXPECT_NEAR(found.time_s, 10.0, 1e-12);
}

TEST(Replay, AStaleTickIsNoEndOfAnInterval) {
  LoggedRun run;
  run.drive(20, 0.012, 0.1);
  run.end();
  run.series[10].flags = flag_stale;
  run.ticks.stale[10] = 1;
  const Replay found = run.replayed(kSquash, kOneTick);
  EXPECT_NEAR(found.length_m, 0.24, 1e-12);
  EXPECT_NEAR(found.gated_time_s, 0.24 / 0.15, 1e-9);
}

TEST(Replay, ABreakCountsNoLength) {
  LoggedRun run;
  run.drive(10, 0.012, 0.1);
  run.x_m += 5.0;
  run.drive(10, 0.012, 0.1);
  run.end();
  run.series[10].flags = flag_break;
  const Replay found = run.replayed(kSquash, kOneTick);
  EXPECT_NEAR(found.length_m, 0.228, 1e-12);
  EXPECT_NEAR(found.slow_s, 0.1, 1e-12);
}

TEST(Replay, TheTrialLimitCanLoseASuccess) {
  LoggedRun run;
  run.drive(100, 0.012, 0.025);
  run.end();
  const Replay found = run.replayed(kSquash, kOneTick);
  EXPECT_TRUE(keeps_success(found, found.gated_time_s));
  EXPECT_FALSE(keeps_success(found, found.gated_time_s - 0.001));
}

TEST(Replay, NothingComesOfNothing) {
  const Replay found = LoggedRun().replayed(kSquash);
  EXPECT_EQ(found.length_m, 0.0);
  EXPECT_FALSE(found.speed_cmd_mps);
  EXPECT_FALSE(rate_of_advance(found.length_m, found.time_s));
  EXPECT_THROW((void)replay(three_segments().ticks, {}, {}), std::invalid_argument);
  EXPECT_THROW(validate(ReplayOptions{0.02, 0.5, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::study
