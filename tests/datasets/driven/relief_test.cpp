#include "datasets/driven/relief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tcert/footing.hpp>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"
#include "datasets/values/check_footing.hpp"

namespace tcert {
namespace {

using namespace driven_test;

DriveParameters with_relief() {
  DriveParameters parameters;
  parameters.ramp_share = 1.0;
  parameters.step_share = 1.0;
  return parameters;
}

const std::vector<ReliefPatch> kRamp{{{{0.0, 0.0}, 1.0}, {1.0, 0.0}, 0.5, 0.0}};
const std::vector<ReliefPatch> kStep{{{{0.0, 0.0}, 1.0}, {1.0, 0.0}, 0.0, 0.06}};

TEST(Relief, IsFeltByTheHeading) {
  const Footing up = footing_at(kRamp, {{0.2, 0.1}, 0.0});
  EXPECT_NEAR(up.pitch_rad, std::atan(0.5), 1e-12);
  EXPECT_NEAR(up.roll_rad, 0.0, 1e-12);
  const Footing down = footing_at(kRamp, {{0.2, 0.1}, std::numbers::pi});
  EXPECT_NEAR(down.pitch_rad, -std::atan(0.5), 1e-12);
  const Footing across = footing_at(kRamp, {{0.2, 0.1}, -0.5 * std::numbers::pi});
  EXPECT_NEAR(across.pitch_rad, 0.0, 1e-12);
  EXPECT_NEAR(across.roll_rad, std::atan(0.5), 1e-12) << "its left side is up";
  for (double yaw = -3.0; yaw < 3.0; yaw += 0.37) {
    EXPECT_NEAR(slope_of(footing_at(kRamp, {{0.2, 0.1}, yaw})), 0.5, 1e-12);
  }
  EXPECT_EQ(slope_of(footing_at(kRamp, {{2.0, 0.0}, 0.0})), 0.0) << "level beside it";
  EXPECT_EQ(footing_at(kStep, {{0.5, 0.0}, 0.0}).step_m, 0.06);
  EXPECT_EQ(footing_at(kStep, {{1.5, 0.0}, 0.0}).step_m, 0.0);
}

TEST(Relief, TakesItsShareOfTheWayUphillAlone) {
  const DriveParameters parameters;  // limits 1.0 and 0.12 m
  EXPECT_NEAR(tread_loss(kRamp, {0.0, 0.0}, {1.0, 0.0}, parameters), 0.25, 1e-12);
  EXPECT_EQ(tread_loss(kRamp, {0.0, 0.0}, {-1.0, 0.0}, parameters), 0.0);
  EXPECT_NEAR(
      tread_loss(kRamp, {0.0, 0.0}, direction(std::numbers::pi / 3.0), parameters), 0.0625, 1e-12);
  EXPECT_NEAR(tread_loss(kStep, {-0.5, 0.0}, {1.0, 0.0}, parameters), 0.25, 1e-12);
  EXPECT_EQ(tread_loss(kStep, {0.5, 0.0}, {1.0, 0.0}, parameters), 0.0) << "down from it";
  EXPECT_EQ(tread_loss(kRamp, {5.0, 0.0}, {1.0, 0.0}, parameters), 0.0);
}

TEST(Relief, SlowsTheBodyAndStopsItAtTheLimit) {
  const DriveParameters parameters;
  World empty;
  empty.bounds = {{-50.0, -50.0}, {50.0, 50.0}};
  const WallIndex walls(empty, kSensingRange);
  const auto way_in_4_s = [&](double slope) {
    const std::vector<ReliefPatch> ramp{{{{0.0, 0.0}, 20.0}, {1.0, 0.0}, slope, 0.0}};
    Body body(parameters, walls, kBodyRadius, {{0.0, 0.0}, 0.0}, ramp);
    for (int i = 0; i < 400; ++i) {
      body.advance(0.01, {0.2, 0.0});
    }
    EXPECT_NEAR(body.slip(), std::min(slope * slope, 1.0), 1e-12);
    return body.pose().position.x_m;
  };
  const double level_m = way_in_4_s(0.0);
  EXPECT_NEAR(way_in_4_s(0.5), 0.75 * level_m, 1e-9);
  EXPECT_EQ(way_in_4_s(1.2), 0.0);
}

TEST(Relief, IsDrawnByItsSharesAndNothingElseChanges) {
  const DrivenWorld level = draw_gated_world({}, 1, 5);
  EXPECT_TRUE(level.relief.empty());
  const DrivenWorld rough = draw_gated_world(with_relief(), 1, 5);
  EXPECT_EQ(rough.relief.size(), 8U) << "a ramp and a step on each of four lanes";
  EXPECT_EQ(rough.gate_margins_m, level.gate_margins_m);
  EXPECT_EQ(rough.lobes, level.lobes);
  for (const ReliefPatch& patch : rough.relief) {
    EXPECT_NEAR(norm(patch.up), 1.0, 1e-12);
    EXPECT_GE(patch.slope, 0.0);
    EXPECT_GE(patch.step_m, 0.0);
    EXPECT_FALSE(contains(*rough.world.start, patch.area.centre));
  }
}

TEST(Relief, IsLoggedWhereThereIsAnyAndMirrors) {
  const DrivenDesign flat = design_driven({}, 1, 3);
  EXPECT_TRUE(drive_trial(flat, LineDriver(flat.world)).trial.log.pose.footing.empty());
  DriveParameters parameters = with_relief();
  parameters.ramp_slope = 0.4;
  parameters.ramp_sd = 0.0;
  parameters.step_height_m = 0.03;
  parameters.step_sd_m = 0.0;
  double steepest = 0.0;
  double highest_m = 0.0;
  double most_slip = 0.0;
  for (std::uint64_t world = 0; world < 5; ++world) {
    const DrivenDesign design = design_driven(parameters, 1, world);
    const DrivenDesign image = mirrored(design);
    const TrialLog log = drive_trial(design, LineDriver(design.world)).trial.log;
    const TrialLog other = drive_trial(image, LineDriver(image.world)).trial.log;
    ASSERT_EQ(log.pose.footing.size(), log.pose.poses.size());
    ASSERT_EQ(log.pose.footing.size(), other.pose.footing.size());
    for (std::size_t i = 0; i < log.pose.footing.size(); ++i) {
      const Footing& a = log.pose.footing[i];
      const Footing& b = other.pose.footing[i];
      ASSERT_EQ(a.pitch_rad, b.pitch_rad) << i;
      ASSERT_EQ(a.roll_rad, -b.roll_rad) << i;
      ASSERT_EQ(a.step_m, b.step_m) << i;
      ASSERT_TRUE(a.slip == b.slip || (std::isnan(a.slip) && std::isnan(b.slip))) << i;
      steepest = std::max(steepest, slope_of(a));
      highest_m = std::max(highest_m, a.step_m);
      most_slip = std::isnan(a.slip) ? most_slip : std::max(most_slip, a.slip);
    }
  }
  // Plausible: what was declared, and noise of 0.01 rad, 5 mm and 0.02.
  EXPECT_NEAR(steepest, 0.4, 0.1);
  EXPECT_NEAR(highest_m, 0.03, 0.03);
  EXPECT_LT(most_slip, 0.16 + 0.0625 + 0.1);
  EXPECT_GT(most_slip, 0.02);
}

TEST(Relief, OtherUnitsAreAskedAbout) {
  TickTable ticks;
  EXPECT_FALSE(check_footing(ticks));
  ticks.footing = {{0.1, -0.2, 0.05, kMissing}, {kMissing, kMissing, 0.0, 0.4}};
  EXPECT_FALSE(check_footing(ticks));
  ticks.footing.push_back({-12.0, 0.0, 0.0, 0.0});
  ASSERT_TRUE(check_footing(ticks));
  EXPECT_EQ(check_footing(ticks)->diagnostic.column, "pitch_rad");
  ticks.footing.back() = {0.0, 0.0, 60.0, 0.0};
  EXPECT_EQ(check_footing(ticks)->diagnostic.column, "step_m");
}

TEST(Relief, ATickHasTheWorstSinceTheTickBefore) {
  TrialLog log;
  log.tactile.rays = 1;
  for (int i = 0; i <= 40; ++i) {
    const std::int64_t time_ns = i * std::int64_t{25'000'000};
    log.pose.time_ns.push_back(time_ns);
    log.pose.poses.push_back({{0.005 * i, 0.0}, 0.0});
    log.pose.footing.push_back({0.0, 0.0, i == 18 ? 0.1 : 0.0, kMissing});
    log.tactile.time_ns.push_back(time_ns);
    log.tactile.readings.push_back({0.5});
  }
  const TickTable ticks = resample(log);
  ASSERT_EQ(ticks.footing.size(), ticks.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks.footing[i].step_m, i == 5 ? 0.1 : 0.0) << i;  // 0.45 s lies before 0.5 s
    EXPECT_TRUE(std::isnan(ticks.footing[i].slip));
  }
}

}  // namespace
}  // namespace tcert
