#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <tcert/headings.hpp>
#include <vector>

namespace tcert::policies {
namespace {

constexpr double kPi = std::numbers::pi;

FeltRay ray(double bearing_rad, double depth) {
  FeltRay felt;
  felt.ahead = unit(bearing_rad);
  felt.depth = depth;
  return felt;
}

TEST(HeadingCosts, GoStraightWhereNothingSpeaksAgainstIt) {
  HeadingCosts costs;
  EXPECT_EQ(costs.cheapest(1), 0);
  EXPECT_EQ(costs.cheapest(-1), 0);
}

TEST(HeadingCosts, BreakTiesByTheLeastTurnAndThenBySide) {
  HeadingCosts costs;
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    costs.add(k, std::abs(k) == 3 || std::abs(k) == 5 ? 1.0 : 2.0);
  }
  EXPECT_EQ(costs.cheapest(1), 3);
  EXPECT_EQ(costs.cheapest(-1), -3);
  costs.add(3, 0.5);
  EXPECT_EQ(costs.cheapest(1), -3);
}

TEST(HeadingCosts, StraightBackIsOneHeading) {
  HeadingCosts costs;
  costs.add(12, -1.0);
  EXPECT_EQ(costs.cheapest(1), 12);
  EXPECT_EQ(costs.cheapest(-1), 12);
  EXPECT_EQ(HeadingCosts::heading(12), (Point{-1.0, 0.0}));
}

TEST(HeadingCosts, TheGoalTermIsTheShareOfHalfATurn) {
  HeadingCosts costs;
  add_goal_cost(costs, 0.5 * kPi, 2.0);
  EXPECT_NEAR(costs[6], 0.0, 1e-15);
  EXPECT_NEAR(costs[0], 1.0, 1e-15);
  EXPECT_NEAR(costs[-6], 2.0, 1e-15);
  EXPECT_NEAR(costs[12], 1.0, 1e-15);
}

// depth 0.5 at 90 degrees and 0.25 ahead: at 0 cos 0 counts 0.25, at 60 degrees both count.
TEST(HeadingCosts, TheClearanceTermIsTheSumOverRaysByTheCosine) {
  const std::array rays{ray(0.5 * kPi, 0.5), ray(0.0, 0.25), ray(1.0, kMissing)};
  HeadingCosts costs;
  add_clearance_cost(costs, rays, 0.3);
  EXPECT_NEAR(costs[0], 0.3 * 0.25, 1e-12);
  EXPECT_NEAR(costs[4], 0.3 * (0.25 * 0.5 + 0.5 * std::cos(kPi / 6.0)), 1e-12);
  EXPECT_NEAR(costs[6], 0.3 * 0.5, 1e-12);
  EXPECT_NEAR(costs[-6], 0.0, 1e-12);
  EXPECT_NEAR(costs[12], 0.0, 1e-12);
}

TEST(HeadingCosts, DoNotDependOnTheOrderOfTheRays) {
  std::vector<FeltRay> rays;
  for (int i = 0; i < 20; ++i) {
    rays.push_back(ray(0.31 * i - 3.0, 0.043 * i));
  }
  HeadingCosts one;
  add_clearance_cost(one, rays, 0.3);
  std::reverse(rays.begin(), rays.end());
  HeadingCosts other;
  add_clearance_cost(other, rays, 0.3);
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    EXPECT_EQ(one[k], other[k]);
  }
}

TEST(TurnInto, GoesForTheBearingWithinItsSector) {
  EXPECT_EQ(turn_into(0, 0.1), 0.1);
  EXPECT_EQ(turn_into(0, 0.2), 0.0);  // 11.5 degrees lie in the next sector
  EXPECT_EQ(turn_into(1, 0.2), 0.2);
  EXPECT_EQ(turn_into(12, -kPi + 0.05), -kPi + 0.05);
}

TEST(MirrorExact, UnitVectorsAreEachOthersImageAtEveryAngle) {
  for (int i = 0; i <= 4800; ++i) {
    const double angle_rad = i * kPi / 4800.0;
    const Point left = unit(angle_rad);
    const Point right = unit(-angle_rad);
    ASSERT_EQ(left.x_m, right.x_m) << angle_rad;
    ASSERT_EQ(left.y_m, -right.y_m) << angle_rad;
    ASSERT_NEAR(left.x_m, std::cos(angle_rad), 1e-15);
    ASSERT_NEAR(left.y_m, std::sin(angle_rad), 1e-15);
  }
}

TEST(MirrorExact, TheBodyFrameIsAFrame) {
  const BodyFrame body = BodyFrame::of({{1.0, -2.0}, 0.7});
  const Point there = body.to_odometry({0.3, 0.4});
  EXPECT_NEAR(distance(there, body.origin), 0.5, 1e-15);
  EXPECT_NEAR(distance(body.to_body(there), {0.3, 0.4}), 0.0, 1e-15);
  EXPECT_NEAR(distance(there, transform({{1.0, -2.0}, 0.7}, {0.3, 0.4})), 0.0, 1e-15);
}

}  // namespace
}  // namespace tcert::policies
