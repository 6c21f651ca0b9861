#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "datasets/corpus/design.hpp"
#include "datasets/corpus/figure_eight.hpp"
#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"
#include "datasets/worlds/world_problems.hpp"

namespace tcert {
namespace {

using namespace driven_test;

bool same_world(const DrivenWorld& a, const DrivenWorld& b) {
  return to_json(a.world) == to_json(b.world) && a.lobes == b.lobes &&
         a.gate_margins_m == b.gate_margins_m && a.start.position == b.start.position &&
         a.start.yaw_rad == b.start.yaw_rad && a.calibration_bias_m == b.calibration_bias_m;
}

TEST(GatedWorld, DependsOnSeedAndNumberAlone) {
  for (const std::uint64_t k : {0U, 1U, 29U, 30U, 700U}) {
    const DrivenWorld world = draw_gated_world({}, 4, k);
    EXPECT_TRUE(same_world(world, draw_gated_world({}, 4, k)));
    EXPECT_FALSE(same_world(world, draw_gated_world({}, 4, k + 1)));
    EXPECT_FALSE(same_world(world, draw_gated_world({}, 5, k)));
    EXPECT_TRUE(world_problems(world.world).empty());
  }
}

// What is not the world's leaves it alone: whoever drives, at whatever step, meets the same one.
TEST(GatedWorld, IsTheSameForEveryDriver) {
  DriveParameters other;
  other.step_s = 0.002;
  other.friction = 0.7;
  other.crash_force_n = 1.0;
  other.seen_dark = 0.1;
  EXPECT_TRUE(same_world(draw_gated_world({}, 4, 2), draw_gated_world(other, 4, 2)));
}

TEST(GatedWorld, HasLanesFromSToGAndStandsInS) {
  bool faced_upper = false;
  bool faced_lower = false;
  for (std::uint64_t k = 0; k < 50; ++k) {
    const DrivenWorld world = draw_gated_world({}, 1, k);
    EXPECT_TRUE(contains(*world.world.start, world.start.position));
    ASSERT_EQ(world.lobes.size(), 2U);
    for (std::size_t lobe = 0; lobe < 2; ++lobe) {
      ASSERT_EQ(world.lobes[lobe].size(), 2U);
      for (const auto& lane : world.lobes[lobe]) {
        EXPECT_TRUE(contains(lobe == 0 ? *world.world.start : *world.world.goal,
                             lobe == 0 ? lane.front() : lane.back()));
        EXPECT_LT(norm(lobe == 0 ? lane.back() : lane.front()), 1e-9);  // the crossing
        for (std::size_t i = 1; i < lane.size(); ++i) {
          EXPECT_GT(distance(lane[i - 1], lane[i]), 0.05);
          EXPECT_LT(distance(lane[i - 1], lane[i]), 0.21);
        }
      }
    }
    // It faces the lane that is listed first.
    const Point ahead = world.lobes[0][0][1] - world.lobes[0][0][0];
    EXPECT_GT(dot(ahead, direction(world.start.yaw_rad)), 0.0);
    faced_upper = faced_upper || world.lobes[0][0][2].y_m > 0.0;
    faced_lower = faced_lower || world.lobes[0][0][2].y_m < 0.0;
  }
  EXPECT_TRUE(faced_upper);
  EXPECT_TRUE(faced_lower);
}

/// Width of the narrowest gap between the walls where a disc of that width still gets from S to G
/// along one lane of each lobe, by the worlds' own gates: measured on the walls.
double measured_margin(const DrivenWorld& world) {
  const WallIndex walls = walls_of(world, 0.7);
  double worse = 1.0;
  for (const auto& lanes : world.lobes) {
    double better = -1.0;
    for (const auto& lane : lanes) {
      double least = 1.0;
      for (std::size_t i = 1; i < lane.size(); ++i) {
        const Point ahead = lane[i] - lane[i - 1];
        const Point left = (1.0 / norm(ahead)) * Point{-ahead.y_m, ahead.x_m};
        for (int j = 0; j < 20; ++j) {
          const Point p = lane[i - 1] + (j / 20.0) * ahead;
          least =
              std::min(least, walls.cast(p, p, left, 0.65) + walls.cast(p, p, -1.0 * left, 0.65));
        }
      }
      better = std::max(better, least);
    }
    worse = std::min(worse, better);
  }
  return worse - 2.0 * kBodyRadius;
}

// Across a bend's chord a gate reads at most 1 cm wider than it is.
TEST(GatedWorld, HasTheMarginThatItsWallsHave) {
  for (std::uint64_t k = 0; k < 40; ++k) {
    const DrivenWorld world = draw_gated_world({}, 3, k);
    EXPECT_NEAR(measured_margin(world), *world.margin_m, 0.015) << k;
  }
}

TEST(GatedWorld, IsDrawnUntilItIsPassableWhereThatIsAskedFor) {
  DriveParameters parameters;
  parameters.choice = WorldChoice::any;
  DriveParameters passable = parameters;
  passable.choice = WorldChoice::passable;
  std::uint32_t redraws = 0;
  int shut = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    const DrivenWorld any = draw_gated_world(parameters, 1, k);
    const DrivenWorld chosen = draw_gated_world(passable, 1, k);
    EXPECT_EQ(any.redraws, 0U);
    EXPECT_GT(*chosen.margin_m, 0.0);
    EXPECT_EQ(chosen.redraws == 0, *any.margin_m > 0.0);
    EXPECT_EQ(chosen.redraws == 0, same_world(any, chosen));
    redraws += chosen.redraws;
    shut += *any.margin_m > 0.0 ? 0 : 1;
  }
  EXPECT_GE(redraws, static_cast<std::uint32_t>(shut));
  EXPECT_GT(shut, 10);
  passable.gate_margin_m = -0.4;
  EXPECT_THROW(static_cast<void>(draw_gated_world(passable, 1, 0)), std::invalid_argument);
}

TEST(DrivenWorld, OfARandomWorldLeadsFromSToGInFreeSpace) {
  for (std::uint64_t i = 0; i < 10 * kWorldFamilies; ++i) {
    const auto family = static_cast<WorldFamily>(i % kWorldFamilies);
    const RandomWorld drawn = draw_random_world(family, 4, i);
    SCOPED_TRACE(drawn.world.name);
    const DrivenWorld world = driven_world(drawn);
    EXPECT_TRUE(contains(*world.world.start, world.start.position));
    ASSERT_EQ(world.lobes.size(), 1U);
    const auto& lane = world.lobes[0][0];
    ASSERT_GE(lane.size(), 2U);
    EXPECT_EQ(lane.back(), middle_of(*world.world.goal));
    const WallIndex walls = walls_of(world, 0.7);
    for (std::size_t j = 0; j + 1 < lane.size(); ++j) {
      EXPECT_FALSE(contains(*world.world.goal, lane[j]));
      EXPECT_GT(walls.distance_from(lane[j]), 0.1);
      EXPECT_LT(distance(lane[j], lane[j + 1]), 0.75);
      EXPECT_GT(distance(lane[j], lane[j + 1]), 0.0);
    }
    EXPECT_NO_THROW(DrivenRun(design_of(world)));
  }
}

}  // namespace
}  // namespace tcert
