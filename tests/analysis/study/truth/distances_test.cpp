// Distances found cleverly against distances found by looking at everything.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/study/truth/arc.hpp"
#include "analysis/study/truth/cell_grid.hpp"
#include "analysis/study/truth/obstacle_distance.hpp"
#include "analysis/study/truth/random_worlds.hpp"
#include "datasets/worlds/region_distance.hpp"

namespace tcert::study {
namespace {

World mixed_world(std::uint64_t index) {
  World world = test_support::random_disc_world(index, false);
  world.obstacles.emplace_back(Polygon{{{1.5, 0.2}, {2.5, 0.3}, {2.0, 1.1}}});
  return world;
}

double distance_by_all(const World& world, Point p) {
  double least = std::min({p.x_m - world.bounds.low.x_m,
                           p.y_m - world.bounds.low.y_m,
                           world.bounds.high.x_m - p.x_m,
                           world.bounds.high.y_m - p.y_m});
  for (const Region& obstacle : world.obstacles) {
    least = std::min(least, region_distance(obstacle, p));
  }
  return least;
}

TEST(ObstacleDistance, IsTheLeastOfAllObstacles) {
  table::RandomStream random(3, 1, 0);
  for (std::uint64_t i = 0; i < 50; ++i) {
    const World world = mixed_world(i);
    const ObstacleDistance obstacles(world);
    for (int k = 0; k < 100; ++k) {
      const Point p{random.uniform(0.0, 4.0), random.uniform(0.0, 3.0)};
      if (!contains(world.obstacles.back(), p)) {
        EXPECT_NEAR(obstacles.at(p), distance_by_all(world, p), 1e-12);
      }
    }
  }
}

TEST(ArcClearance, IsNeverAboveAnySample) {
  table::RandomStream random(3, 2, 0);
  for (std::uint64_t i = 0; i < 50; ++i) {
    const ObstacleDistance obstacles(mixed_world(i));
    const Arc arc{{{random.uniform(0.5, 3.5), random.uniform(0.5, 2.5)}, random.uniform(-3.0, 3.0)},
                  random.uniform(-4.0, 4.0),
                  random.uniform(0.0, 1.0)};
    double least = HUGE_VAL;
    for (int k = 0; k <= 2000; ++k) {
      least = std::min(least, obstacles.at(pose_at(arc, arc.length_m * k / 2000).position));
    }
    const double bound = arc_clearance(arc, obstacles, 1e-3);
    EXPECT_LE(bound, least);
    EXPECT_GE(bound, std::max(least - 2e-3, 0.0) - 1e-12);
  }
}

TEST(CellGrid, DistancesAreTheLeastOfAllMarkedCells) {
  for (std::uint64_t i = 0; i < 10; ++i) {
    const World world = mixed_world(i);
    const CellGrid grid = cell_grid(world, 0.13);
    std::vector<std::uint8_t> marks(grid.size(), 0);
    for (const Region& obstacle : world.obstacles) {
      mark_region(grid, obstacle, 0.05, marks);
    }
    const std::vector<std::uint32_t> squared = squared_distances(grid, marks);
    for (std::size_t a = 0; a < grid.size(); ++a) {
      bool marked = false;
      for (const Region& obstacle : world.obstacles) {
        marked = marked || region_distance(obstacle, grid.centre(a)) <= 0.05;
      }
      ASSERT_EQ(marks[a] != 0, marked);
      const std::size_t x = a % grid.columns;
      const std::size_t y = a / grid.columns;
      const std::size_t out = std::min({x + 1, y + 1, grid.columns - x, grid.rows - y});
      std::size_t least = out * out;
      for (std::size_t b = 0; b < grid.size(); ++b) {
        if (marks[b] != 0) {
          const std::size_t dx = std::max(x, b % grid.columns) - std::min(x, b % grid.columns);
          const std::size_t dy = std::max(y, b / grid.columns) - std::min(y, b / grid.columns);
          least = std::min(least, dx * dx + dy * dy);
        }
      }
      ASSERT_EQ(squared[a], least);
    }
  }
}

}  // namespace
}  // namespace tcert::study
