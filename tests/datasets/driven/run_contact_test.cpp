#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"
#include "datasets/worlds/region_distance.hpp"

namespace tcert {
namespace {

using namespace driven_test;

// Pushing straight ahead at a closed gate with 75 N: n bumps of bearing 0 and of that force, with
// the declared noise. Four standard errors of each.
TEST(DrivenRun, FeelsItsBumpsWithTheDeclaredNoise) {
  DrivenRun run(design_of(gated_corridor(3.0, 1.2, 0.1), uncrashable()));
  std::vector<double> bearings;
  std::vector<double> logs;
  while (const policies::Senses* senses = run.next()) {
    if (run.now_s() > 8.0) {
      ASSERT_TRUE(senses->bump);
      bearings.push_back(senses->bump->bearing_rad);
      logs.push_back(std::log(senses->bump->force_n / 75.0));
    }
    run.take({0.2, 0.0});
  }
  ASSERT_GT(bearings.size(), 900U);
  const auto n = static_cast<double>(bearings.size());
  for (const auto* values : {&bearings, &logs}) {
    double sum = 0.0;
    double sum2 = 0.0;
    for (const double v : *values) {
      sum += v;
      sum2 += v * v;
    }
    EXPECT_NEAR(sum / n, 0.0, 4.0 * 0.05 / std::sqrt(n));
    EXPECT_NEAR(std::sqrt(sum2 / n), 0.05, 4.0 * 0.05 / std::sqrt(2.0 * n));
  }
}

/// Drives ahead and notes when the body first touches.
struct Timed {
  double speed_mps = 0.0;
  double* first_touch_s = nullptr;
  policies::Command operator()(const policies::Senses& senses) const {
    if (senses.bump && *first_touch_s < 0.0) {
      *first_touch_s = 1e-9 * static_cast<double>(senses.tick.time_ns);
    }
    return {speed_mps, 0.0};
  }
};

// The same commands at 10 ms and at 2 ms: touched within a control period of each other, by the
// same force to 1 N, with the same end at the same place. (When the stalls of a wedge are called
// depends on where the last stretch of 2 cm began, so its time is left out.)
TEST(DrivenRun, EndsTheSameWhateverItsStep) {
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    DrivenDesign design =
        design_of(gated_corridor(3.0, 1.2, i % 3 == 0 ? 0.3 : 0.44 + 0.004 * i), uncrashable());
    design.world.start.position.y_m = 0.004 * (i - 15);
    design.parameters.time_limit_s = 60.0;
    const double speed = 0.10 + 0.005 * i;
    double coarse_touch = -1.0;
    double fine_touch = -1.0;
    const DrivenTrial coarse = drive_trial(design, Timed{speed, &coarse_touch});
    design.parameters.step_s = 0.002;
    const DrivenTrial fine = drive_trial(design, Timed{speed, &fine_touch});
    EXPECT_NEAR(coarse_touch, fine_touch, 0.02 + 1e-9);
    EXPECT_EQ(coarse.trial.row.end_reason, fine.trial.row.end_reason);
    EXPECT_NEAR(*coarse.trial.row.distance_m, *fine.trial.row.distance_m, 0.005);
    EXPECT_NEAR(coarse.events.peak_force_n, fine.events.peak_force_n, 1.0);
    EXPECT_EQ(coarse.events.bumps, fine.events.bumps);
    EXPECT_EQ(coarse.events.stalls, fine.events.stalls);
  }
}

/// Depth of the body in the walls, measured on the polygons and discs themselves.
double depth_in_walls(const DrivenWorld& world, Point p) {
  double depth = 0.0;
  for (const auto* walls : {&world.world.obstacles, &world.edge_walls}) {
    for (const Region& wall : *walls) {
      depth = std::max(depth, kBodyRadius - region_distance(wall, p));
    }
  }
  return depth;
}

// 400 runs in figure-8s, 600 in random worlds of all families, 12 s each, at up to 0.3 m/s.
TEST(DrivenRun, NeverLeavesTheBodyInAWall) {
  double deepest = 0.0;
  std::size_t touching = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    DrivenDesign design;
    if (i < 400) {
      design = design_driven({}, 1, i);
    } else {
      const auto family = static_cast<WorldFamily>(i % kWorldFamilies);
      design.world = driven_world(draw_random_world(family, 1, i));
      design.index = i;
    }
    design.parameters.crash_force_n = 1e6;
    design.parameters.time_limit_s = 12.0;
    DrivenRun run(design);
    Wanderer wanderer(1, i);
    while (const policies::Senses* senses = run.next()) {
      touching += run.body().hold().force_n > 0.0 ? 1 : 0;
      deepest = std::max(deepest, depth_in_walls(design.world, run.body().pose().position));
      run.take(wanderer(*senses));
    }
  }
  std::printf("deepest in a wall %.3g m; touching at %zu control steps\n", deepest, touching);
  EXPECT_GT(touching, 10'000U);
  EXPECT_LT(deepest, 1e-9);  // the bound asked for is 1 mm; half planes keep it to rounding
}

}  // namespace
}  // namespace tcert
