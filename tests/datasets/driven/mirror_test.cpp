#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <table/random.hpp>
#include <tcert/elementary.hpp>

#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"

namespace tcert {
namespace {

using namespace driven_test;

// Away from the ties of the reduction, k pi/2 + pi/4, the two bits are each other's image.
TEST(Mirroring, IsExactInSineAndCosine) {
  table::RandomStream random(1, 0x7465'0007, 0);
  for (int i = 0; i < 1'000'000; ++i) {
    const double angle = random.uniform(0.0, 8.0);
    const auto [sine, cosine] = elementary::sine_cosine(angle);
    const auto image = elementary::sine_cosine(-angle);
    ASSERT_EQ(image.sine, -sine) << angle;
    ASSERT_EQ(image.cosine, cosine) << angle;
  }
}

void expect_mirrored(const TrialLog& log, const TrialLog& image) {
  ASSERT_EQ(log.pose.time_ns, image.pose.time_ns);
  for (std::size_t i = 0; i < log.pose.poses.size(); ++i) {
    const Pose& p = log.pose.poses[i];
    const Pose& q = image.pose.poses[i];
    ASSERT_EQ(p.position.x_m, q.position.x_m) << i;
    ASSERT_EQ(p.position.y_m, -q.position.y_m) << i;
    ASSERT_EQ(p.yaw_rad, -q.yaw_rad) << i;
  }
  ASSERT_EQ(log.tactile.time_ns, image.tactile.time_ns);
  for (std::size_t i = 0; i < log.tactile.time_ns.size(); ++i) {
    const RayReading* a = &log.tactile.readings[i * kTentacles];
    const RayReading* b = &image.tactile.readings[i * kTentacles];
    for (const auto& [k, other] : {std::pair{0, 1}, std::pair{1, 0}, std::pair{2, 2}}) {
      ASSERT_EQ(a[k].value, b[other].value) << i;
      ASSERT_EQ(a[k].fsr_n, b[other].fsr_n) << i;
      ASSERT_TRUE(std::isnan(a[k].bearing_rad) ? std::isnan(b[other].bearing_rad)
                                               : a[k].bearing_rad == -b[other].bearing_rad);
    }
  }
  ASSERT_EQ(log.control.time_ns, image.control.time_ns);
  ASSERT_EQ(log.control.speed_cmd_mps, image.control.speed_cmd_mps);
  ASSERT_EQ(log.control.loop_latency_ms, image.control.loop_latency_ms);
  for (std::size_t i = 0; i < log.control.time_ns.size(); ++i) {
    ASSERT_EQ(log.control.yaw_rate_cmd_rps[i], -image.control.yaw_rate_cmd_rps[i]) << i;
  }
}

void expect_same_fate(const DrivenTrial& trial, const DrivenTrial& image) {
  EXPECT_EQ(trial.trial.row.end_reason, image.trial.row.end_reason);
  EXPECT_EQ(trial.trial.row.time_s, image.trial.row.time_s);
  EXPECT_EQ(trial.trial.row.distance_m, image.trial.row.distance_m);
  EXPECT_EQ(trial.trial.row.extra, image.trial.row.extra);
}

TEST(Mirroring, OfAWorldAndItsDrawsMirrorsTheLogBitForBit) {
  DriveParameters parameters;
  parameters.time_limit_s = 60.0;
  std::uint32_t bumps = 0;
  for (std::uint64_t index = 0; index < 60; ++index) {
    SCOPED_TRACE(index);
    DrivenDesign design = design_driven(parameters, 5, index);
    design.native_rates = true;
    const DrivenDesign image = mirrored(design);
    const DrivenTrial trial = drive_trial(design, LineDriver(design.world));
    const DrivenTrial reflected = drive_trial(image, LineDriver(image.world));
    expect_mirrored(trial.trial.log, reflected.trial.log);
    expect_same_fate(trial, reflected);
    bumps += trial.events.bumps;
  }
  EXPECT_GT(bumps, 100U);
}

TEST(Mirroring, OfAJointMirrorsItsBearings) {
  DriveParameters parameters;
  parameters.time_limit_s = 20.0;
  parameters.sweep_rad = 1.2;
  for (std::uint64_t index = 0; index < 6; ++index) {
    SCOPED_TRACE(index);
    const DrivenDesign design = design_driven(parameters, 5, index);
    const DrivenDesign image = mirrored(design);
    expect_mirrored(drive_trial(design, LineDriver(design.world)).trial.log,
                    drive_trial(image, LineDriver(image.world)).trial.log);
  }
}

TEST(Mirroring, HoldsInRandomWorldsOfEveryFamily) {
  for (std::uint64_t i = 0; i < 2 * kWorldFamilies; ++i) {
    SCOPED_TRACE(i);
    DrivenDesign design;
    design.world =
        driven_world(draw_random_world(static_cast<WorldFamily>(i % kWorldFamilies), 2, i));
    design.index = i;
    design.native_rates = true;
    design.parameters.crash_force_n = 1e6;
    design.parameters.time_limit_s = 30.0;
    const DrivenDesign image = mirrored(design);
    const DrivenTrial trial = drive_trial(design, Wanderer(2, i));
    const DrivenTrial reflected = drive_trial(image, Wanderer(2, i, true));
    expect_mirrored(trial.trial.log, reflected.trial.log);
    expect_same_fate(trial, reflected);
  }
}

TEST(Mirroring, MirrorsBumpsAndSightings) {
  DrivenDesign design = design_driven({}, 5, 3);
  design.camera = true;
  design.lighting = Lighting::dark;
  design.parameters.crash_force_n = 1e6;
  const DrivenDesign image = mirrored(design);
  DrivenRun run(design);
  DrivenRun reflected(image);
  Wanderer wanderer(3, 1);
  Wanderer other(3, 1, true);
  std::size_t bumps = 0;
  std::size_t sightings = 0;
  while (const policies::Senses* a = run.next()) {
    const policies::Senses* b = reflected.next();
    ASSERT_NE(b, nullptr);
    ASSERT_EQ(a->bump.has_value(), b->bump.has_value());
    if (a->bump) {
      ++bumps;
      ASSERT_EQ(a->bump->force_n, b->bump->force_n);
      ASSERT_EQ(a->bump->bearing_rad, -b->bump->bearing_rad);
    }
    ASSERT_EQ(a->camera.size(), b->camera.size());
    for (std::size_t i = 0; i < a->camera.size(); ++i) {
      ++sightings;
      ASSERT_EQ(a->camera[i].range_m, b->camera[i].range_m);
      ASSERT_EQ(a->camera[i].bearing_rad, -b->camera[i].bearing_rad);
    }
    ASSERT_EQ(a->speed_mps, b->speed_mps);
    ASSERT_EQ(a->travel_m, b->travel_m);
    run.take(wanderer(*a));
    reflected.take(other(*b));
  }
  EXPECT_EQ(reflected.next(), nullptr);
  EXPECT_GT(bumps, 20U);
  EXPECT_GT(sightings, 1000U);
}

TEST(Mirroring, TwiceIsTheSameWorld) {
  const DrivenWorld world = draw_gated_world({}, 5, 8);
  const DrivenWorld twice = mirrored(mirrored(world));
  EXPECT_EQ(to_json(twice.world), to_json(world.world));
  EXPECT_EQ(twice.lobes, world.lobes);
  EXPECT_NE(to_json(mirrored(world).world), to_json(world.world));
}

}  // namespace
}  // namespace tcert
