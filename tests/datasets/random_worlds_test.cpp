#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/random_run.hpp"
#include "datasets/random_worlds/walled_lane.hpp"
#include "datasets/worlds/region_distance.hpp"

namespace tcert {
namespace {

std::vector<WorldFamily> all_families() {
  std::vector<WorldFamily> families;
  for (std::size_t i = 0; i < kWorldFamilies; ++i) {
    families.push_back(static_cast<WorldFamily>(i));
  }
  return families;
}

TEST(RandomWorlds, AreTheSameForTheSameNumber) {
  for (const WorldFamily family : all_families()) {
    const RandomWorld once = draw_random_world(family, 2, 7);
    EXPECT_EQ(to_json(once.world), to_json(draw_random_world(family, 2, 7).world));
    EXPECT_NE(to_json(once.world), to_json(draw_random_world(family, 2, 8).world));
    EXPECT_TRUE(once.world.synthetic);
  }
}

TEST(RandomWorlds, RunsStartInSAndKeepTheBodyOffTheWalls) {
  for (const WorldFamily family : all_families()) {
    std::size_t reached = 0;
    for (std::uint64_t i = 0; i < 30; ++i) {
      const RandomWorld drawn = draw_random_world(family, 2, i);
      SCOPED_TRACE(drawn.world.name);
      const WallIndex walls = feelable_walls(drawn);
      const Drive driven = follow_legs(drawn, walls, 2, i);
      ASSERT_FALSE(driven.poses.empty());
      EXPECT_TRUE(contains(*drawn.world.start, driven.poses.front().position));
      for (const Pose& pose : driven.poses) {
        ASSERT_GE(walls.distance_from(pose.position), 0.225 + 0.0005 - 1e-12);
      }
      if (driven.end_reason == EndReason::goal) {
        ++reached;
        EXPECT_TRUE(std::any_of(driven.poses.begin(), driven.poses.end(), [&](const Pose& pose) {
          return contains(*drawn.world.goal, pose.position);
        }));
      }
    }
    EXPECT_GT(reached, 8U) << name_of(family);
  }
}

TEST(RandomWorlds, TrueTicksAreWhatTheWallsAre) {
  const RandomWorld drawn = draw_random_world(WorldFamily::discs, 2, 1);
  const WallIndex walls = feelable_walls(drawn);
  const Drive driven = follow_legs(drawn, walls, 2, 1);
  const TickTable ticks = true_ticks(driven, walls);
  ASSERT_EQ(ticks.size(), (driven.poses.size() + 1) / 2);
  const Robot& robot = corpus_robot();
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    const auto clearances = cast_tentacles(walls, driven.poses[2 * k]);
    for (std::size_t r = 0; r < kTentacles; ++r) {
      EXPECT_NEAR(calibrated_clearance(robot.rays[r].calibration, ticks[k].rays[r].value),
                  clearances[r],
                  1e-12);
    }
  }
}

// A disc of the lane's width gets along the chords of the centre line, and between every two of
// them lies a segment of that length from wall to wall.
TEST(RandomWorlds, ALaneIsAsWideAsItSaysInItsTightestBend) {
  WalledLane lane;
  lane.begin = {{0.3, -0.2}, 0.4};
  lane.width_m = 1.1;
  lane.pieces = {
      {1.03, 0.0}, {1.2, 1.0 / 0.85}, {2.1, -1.0 / 0.85}, {0.31, 0.0}, {0.5, 1.0}, {1.0, 0.0}};
  World world;
  add_walls(world, lane);
  const auto steps = static_cast<int>(std::ceil(length_of(lane) / 0.08));
  for (int i = 0; i < steps; ++i) {
    const Point from = pose_at(lane, length_of(lane) * i / steps).position;
    const Point to = pose_at(lane, length_of(lane) * (i + 1) / steps).position;
    for (int k = 0; k <= 20; ++k) {
      const Point p = from + k / 20.0 * (to - from);
      for (const Region& wall : world.obstacles) {
        ASSERT_GE(region_distance(wall, p), 0.55 - 1e-12) << i << " " << k;
      }
    }
    const Point middle = 0.5 * (from + to);
    for (const Region& wall : world.obstacles) {
      ASSERT_NEAR(region_distance(wall, middle), 0.55, 1e-12) << i;
    }
  }
}

TEST(RandomWorlds, ALoopIsAsWideAllRound) {
  const World world = draw_random_world(WorldFamily::loop, 2, 1).world;
  const std::size_t ring = world.obstacles.size() - 73;
  const Region& island = world.obstacles.back();
  const double radius = std::get<Disc>(*world.goal).centre.x_m;
  const double half =
      radius - std::get<Polygon>(island).vertices.front().x_m * std::cos(std::numbers::pi / 72.0);
  for (int i = 0; i < 720; ++i) {
    const double angle = i * std::numbers::pi / 360.0;
    const double off_middle =
        std::remainder(angle - std::numbers::pi / 72.0, std::numbers::pi / 36);
    const Point p = radius / std::cos(off_middle) * direction(angle);
    double outer = 10.0;
    for (std::size_t k = ring; k + 1 < world.obstacles.size(); ++k) {
      outer = std::min(outer, region_distance(world.obstacles[k], p));
    }
    ASSERT_NEAR(outer, half, 1e-12) << i;
    ASSERT_GE(region_distance(island, p), half - 1e-12) << i;
  }
}

// Against the disc's equation, along many rays.
TEST(WallIndex, FeelsDiscs) {
  World world;
  world.bounds = {{-1.0, -1.0}, {1.0, 1.0}};
  const Disc disc{{0.3, 0.1}, 0.12};
  world.obstacles = {disc};
  const WallIndex walls(world, 0.7);
  for (int i = 0; i < 360; ++i) {
    const Point u = direction(i * std::numbers::pi / 180.0);
    const double felt = walls.cast({0.0, 0.0}, {0.0, 0.0}, u, 0.6);
    if (felt < 0.6) {
      EXPECT_NEAR(distance(felt * u, disc.centre), disc.radius_m, 1e-12);
    }
    for (int step = 0; step < 100; ++step) {
      EXPECT_GE(distance(felt * step / 100.0 * u, disc.centre), disc.radius_m - 1e-12);
    }
    EXPECT_EQ(felt < 0.6,
              std::abs(cross(u, disc.centre)) < disc.radius_m && dot(u, disc.centre) > 0.0);
  }
  EXPECT_NEAR(walls.distance_from({0.3, 0.4}), 0.18, 1e-12);
  EXPECT_EQ(walls.cast({0.3, 0.1}, {0.3, 0.1}, {1.0, 0.0}, 0.6), 0.0);
  const auto [moved, is_free] = walls.pushed_out({0.3, 0.3}, 0.225);
  EXPECT_TRUE(is_free);
  EXPECT_NEAR(moved.y_m, 0.1 + 0.12 + 0.225, 1e-12);
}

}  // namespace
}  // namespace tcert
