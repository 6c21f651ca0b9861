#include "analysis/study/truth/clearance_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/study/truth/random_worlds.hpp"

namespace tcert::study {
namespace {

World field(std::vector<Disc> discs) {
  World world;
  world.name = "test";
  world.bounds = {{0.0, 0.0}, {10.0, 4.0}};
  world.start = Disc{{1.0, 2.0}, 0.2};
  world.goal = Disc{{9.0, 2.0}, 0.2};
  world.obstacles.assign(discs.begin(), discs.end());
  return world;
}

TEST(ExactDiscClearance, WithoutObstaclesTheCorridorDecides) {
  EXPECT_DOUBLE_EQ(exact_disc_clearance(field({})).clearance_m, 1.2);  // S's far edge from the wall
}

TEST(ExactDiscClearance, FindsTheGapsBetweenDiscs) {
  // A column of three discs: gaps of 0.5, 0.8 and, to the walls, 0.35 and 0.15.
  const World world = field({{{5.0, 0.65}, 0.3}, {{5.0, 1.85}, 0.4}, {{5.0, 3.4}, 0.35}});
  const ClearanceValue value = exact_disc_clearance(world);
  EXPECT_NEAR(value.clearance_m, 0.4, 1e-12);
  ASSERT_TRUE(value.bottleneck);
  EXPECT_NEAR(value.bottleneck->x_m, 5.0, 1e-12);
  EXPECT_NEAR(value.bottleneck->y_m, 2.65, 1e-12);
}

TEST(ExactDiscClearance, NoPathIsMinusInfinity) {
  std::vector<Disc> wall;
  for (int i = 0; i <= 20; ++i) {
    wall.push_back({{5.0, 0.2 * i}, 0.1});  // each touches the next, or overlaps it
  }
  const ClearanceValue value = exact_disc_clearance(field(wall));
  EXPECT_TRUE(std::isinf(value.clearance_m) && value.clearance_m < 0.0);
  EXPECT_FALSE(value.bottleneck);
}

TEST(ExactDiscClearance, ARingRoundTheGoalSeparates) {
  std::vector<Disc> ring;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / 12;
    ring.push_back({Point{9.0, 2.0} + 0.8 * direction(angle), 0.1});
  }
  const double chord = 2.0 * 0.8 * std::sin(std::acos(-1.0) / 12);
  EXPECT_NEAR(exact_disc_clearance(field(ring)).clearance_m, 0.5 * (chord - 0.2), 1e-12);
}

TEST(ExactDiscClearance, TheGapInsideTheStartCountsOnlyOnTheWay) {
  // Two discs with their gap in the middle of S: a path may begin on the far side.
  World world = field({{{1.0, 2.6}, 0.35}, {{1.0, 1.4}, 0.35}});
  world.start = Disc{{1.0, 2.0}, 0.24};
  const double best = std::hypot(0.24, 0.6) - 0.35;  // at (1.24, 2)
  EXPECT_NEAR(exact_disc_clearance(world).clearance_m, best, 1e-9);
}

class RandomDiscWorlds : public testing::TestWithParam<bool> {};

TEST_P(RandomDiscWorlds, ExactAndGridAgreeWithinTheBound) {
  int with_path = 0;
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const World world = test_support::random_disc_world(i, GetParam());
    const ClearanceValue exact = exact_disc_clearance(world);
    const ClearanceValue grid = grid_clearance(world, 0.01).value;
    EXPECT_LE(exact.clearance_m, grid.upper_m + 1e-12) << world.name;
    EXPECT_GE(exact.clearance_m, grid.lower_m - 1e-12) << world.name;
    if (std::isfinite(exact.clearance_m) && std::isfinite(grid.clearance_m)) {
      ++with_path;
      worst = std::max(worst, std::abs(exact.clearance_m - grid.clearance_m));
    }
  }
  EXPECT_GT(with_path, 200);
  RecordProperty("worst_difference_mm", static_cast<int>(1000.0 * worst));
}

INSTANTIATE_TEST_SUITE_P(Radii, RandomDiscWorlds, testing::Bool(), [](const auto& test) {
  return test.param ? "equal" : "unequal";
});

}  // namespace
}  // namespace tcert::study
