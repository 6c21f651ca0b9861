#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"

namespace tcert {
namespace {

using namespace driven_test;

constexpr double kControl = 0.02;

double first_motion_s(const TrialLog& log) {
  return 1e-9 * static_cast<double>(log.control.time_ns.front()) +
         1e-3 * log.control.loop_latency_ms.front();
}

// From the first command's effect the body speeds up at a to v and drives on to G's edge: way / v
// and v / (2 a) more.
TEST(DrivenRun, TakesAnEmptyCorridorInTheTimeThatSpeedAndAccelerationGive) {
  for (const double length : {2.0, 6.5}) {
    for (const double speed : {0.10, 0.17, 0.29}) {
      for (const double acceleration : {0.2, 0.5}) {
        DrivenDesign design = design_of(corridor(length, 1.2));
        design.parameters.acceleration_mps2 = acceleration;
        design.native_rates = true;
        const DrivenTrial driven = drive_trial(design, Steady{speed});
        const TrialRow& row = driven.trial.row;
        ASSERT_EQ(row.end_reason, EndReason::goal);
        const double way = length - 0.3;
        const double expected =
            first_motion_s(driven.trial.log) + way / speed + speed / (2.0 * acceleration);
        EXPECT_NEAR(*row.time_s, expected, kControl);
        EXPECT_NEAR(*row.distance_m, way, speed * kControl);
        EXPECT_EQ(driven.events.peak_force_n, 0.0);
        EXPECT_EQ(driven.events.bumps, 0U);
      }
    }
  }
}

// x = a t^2 / 2 from the very instant at which the first command acts: no latency is rounded to a
// step, neither one shorter than a control period nor one of several.
TEST(DrivenRun, ActsOnACommandALatencyLater) {
  for (const double latency_ms : {0.0, 7.3, 19.6, 23.1, 104.9}) {
    DrivenDesign design = design_of(corridor(4.0, 1.2));
    design.parameters.latency_ms = latency_ms;
    design.parameters.latency_spread_ms = 0.0;
    DrivenRun run(design);
    double first_s = -1.0;
    while (run.next() != nullptr && run.now_s() < 0.45) {
      if (first_s < 0.0) {
        first_s = run.now_s();
      }
      const double since = std::max(run.now_s() - first_s - 1e-3 * latency_ms, 0.0);
      EXPECT_NEAR(run.body().pose().position.x_m, 0.25 * since * since, 1e-12) << latency_ms;
      run.take({0.29, 0.0});
    }
  }
}

TEST(DrivenRun, LogsTheLatencyThatEachCommandHad) {
  DrivenDesign design = design_of(corridor(4.0, 1.2));
  design.native_rates = true;
  const DrivenTrial driven = drive_trial(design, Steady{0.15});
  std::vector<double> latencies = driven.trial.log.control.loop_latency_ms;
  std::sort(latencies.begin(), latencies.end());
  EXPECT_NEAR(latencies[latencies.size() / 2], 19.6, 0.1);
  EXPECT_NE(latencies.front(), latencies.back());
}

TEST(DrivenRun, IsTheSameStepByStepAndAtOnce) {
  const DrivenDesign design = design_driven({}, 3, 4);
  LineDriver once(design.world);
  const DrivenTrial whole = drive_trial(design, once);
  LineDriver again(design.world);
  DrivenRun run(design);
  while (const policies::Senses* senses = run.next()) {
    run.take(again(*senses));
  }
  const DrivenTrial stepped = trial_of(run);
  EXPECT_EQ(whole.trial.row.time_s, stepped.trial.row.time_s);
  EXPECT_EQ(whole.trial.row.extra, stepped.trial.row.extra);
  ASSERT_EQ(whole.trial.log.tactile.time_ns, stepped.trial.log.tactile.time_ns);
  for (std::size_t i = 0; i < whole.trial.log.tactile.readings.size(); ++i) {
    ASSERT_EQ(whole.trial.log.tactile.readings[i].value,
              stepped.trial.log.tactile.readings[i].value);
  }
  for (std::size_t i = 0; i < whole.trial.log.pose.poses.size(); ++i) {
    ASSERT_EQ(whole.trial.log.pose.poses[i].position, stepped.trial.log.pose.poses[i].position);
  }
}

// A policy is given the log's own ticks: at each control step what the resampler makes, in one pass
// at the end, of the samples up to then.
TEST(DrivenRun, HandsOutTheTicksOfItsLog) {
  DrivenDesign design = design_driven({}, 3, 5);
  design.native_rates = true;
  LineDriver driver(design.world);
  TickTable given;
  DrivenRun run(design);
  while (const policies::Senses* senses = run.next()) {
    const Tick& tick = senses->tick;
    given.time_ns.push_back(tick.time_ns);
    given.poses.push_back(tick.pose);
    given.readings.insert(given.readings.end(), tick.rays.begin(), tick.rays.end());
    given.stale.push_back(tick.stale ? 1 : 0);
    run.take(driver(*senses));
  }
  const DrivenTrial driven = trial_of(run);
  Resampler resampler(driven.trial.log, ResampleOptions{});
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Tick tick = resampler.add_tick(given.time_ns[i]);
    ASSERT_EQ(tick.pose.position, given.poses[i].position);
    ASSERT_EQ(tick.pose.yaw_rad, given.poses[i].yaw_rad);
    ASSERT_EQ(tick.stale ? 1 : 0, given.stale[i]);
    for (std::size_t k = 0; k < kTentacles; ++k) {
      ASSERT_EQ(tick.rays[k].value, given.readings[i * kTentacles + k].value);
      ASSERT_EQ(tick.rays[k].fsr_n, given.readings[i * kTentacles + k].fsr_n);
    }
  }
  EXPECT_GT(given.size(), 100U);
}

TEST(DrivenRun, TellsThePolicyWhereGIsAndHowFastItWasToldToDrive) {
  DrivenRun run(design_of(corridor(2.0, 1.2)));
  const policies::Senses* senses = run.next();
  ASSERT_NE(senses, nullptr);
  EXPECT_EQ(senses->goal, (Point{2.0, 0.0}));
  EXPECT_TRUE(std::isnan(senses->commanded_mps));
  EXPECT_TRUE(senses->camera.empty());
  EXPECT_FALSE(senses->bump);
  run.take({0.12, 0.0});
  ASSERT_NE(run.next(), nullptr);
  EXPECT_EQ(senses->commanded_mps, 0.12);
  run.take({std::nan(""), 0.0});
  ASSERT_NE(run.next(), nullptr);
  EXPECT_EQ(senses->commanded_mps, 0.0);
}

TEST(DrivenRun, RefusesABodyThatDoesNotFitAndAWorldWithoutG) {
  DrivenDesign inside = design_of(corridor(2.0, 1.2));
  inside.world.start.position.y_m = 0.5;
  EXPECT_THROW(DrivenRun{inside}, std::invalid_argument);
  DrivenDesign aimless = design_of(corridor(2.0, 1.2));
  aimless.world.world.goal.reset();
  EXPECT_THROW(DrivenRun{aimless}, std::invalid_argument);
  DrivenDesign wrong = design_of(corridor(2.0, 1.2));
  wrong.parameters.friction = -1.0;
  EXPECT_THROW(DrivenRun{wrong}, std::invalid_argument);
  wrong.parameters = {};
  wrong.parameters.time_limit_s = 3600.0;
  wrong.parameters.step_s = 5e-4;
  EXPECT_THROW(DrivenRun{wrong}, std::invalid_argument);
}

}  // namespace
}  // namespace tcert
