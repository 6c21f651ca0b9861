#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <table/random.hpp>

#include "datasets/driven/body.hpp"
#include "datasets/driven/scripted.hpp"

namespace tcert {
namespace {

using driven_test::gated_corridor;
using driven_test::kBodyRadius;

/// Pushes at a gate for 20 s, with random turns and short reversals; the largest x.
double furthest_push(double gate_m, std::uint64_t index, double speed_mps) {
  const WallIndex walls(gated_corridor(2.0, 1.0, gate_m).world, kSensingRange);
  table::RandomStream random(1, 0x7465'0005, index);
  Body body({}, walls, kBodyRadius, {{0.5, random.uniform(-0.05, 0.05)}, 0.0});
  double furthest = 0.0;
  policies::Command command;
  for (int i = 0; i < 2000; ++i) {
    if (i % 40 == 0) {
      const double aim = -std::clamp(2.0 * body.pose().position.y_m, -0.5, 0.5);
      const double turn = aim - body.pose().yaw_rad + 0.2 * random.normal();
      command = {random.below(6) == 0 ? -0.1 : speed_mps, std::clamp(2.5 * turn, -1.0, 1.0)};
    }
    body.advance(0.01, command);
    furthest = std::max(furthest, body.pose().position.x_m);
  }
  return furthest;
}

// The gate's throat is from 0.925 to 1.075 m; a disc that is too wide is stopped before its middle
// is between the jaws.
TEST(Body, NeverPassesAGateNarrowerThanItself) {
  table::RandomStream random(1, 0x7465'0006, 0);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const double margin = i % 4 == 0 ? -0.002 : random.uniform(-0.03, -0.002);
    ASSERT_LT(furthest_push(2.0 * kBodyRadius + margin, i, random.uniform(0.05, 0.3)), 0.925)
        << i << " " << margin;
  }
  for (std::uint64_t i = 0; i < 50; ++i) {
    ASSERT_LT(furthest_push(2.0 * kBodyRadius - 1e-6, i, 0.2), 0.926) << i;
  }
}

// The same pushes would pass if they could.
TEST(Body, PassesAGateThatIsWiderThanItself) {
  int passed = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    passed += furthest_push(2.0 * kBodyRadius + 0.002, i, 0.2) > 1.3 ? 1 : 0;
  }
  std::printf("a gate of +2 mm is passed in %d of 100 runs\n", passed);
  EXPECT_GT(passed, 50);
}

// A corner sharper than a right angle: pushed along one wall into the other, which it would not
// press on of itself, all of its speed is taken.
TEST(Body, IsHeldInASharpCornerByBothWalls) {
  World world;
  world.bounds = {{-3.0, -3.0}, {3.0, 3.0}};
  world.obstacles = {Polygon{{{-2.5, -0.2}, {2.0, -0.2}, {2.0, 0.0}, {-2.5, 0.0}}},
                     Polygon{{{2.0, 0.0}, {-1.0, 2.0}, {2.0, 2.0}}}};
  const WallIndex walls(world, kSensingRange);
  Body body({}, walls, kBodyRadius, {{0.0, 0.3}, -0.5});
  for (int i = 0; i < 2000; ++i) {
    body.advance(0.01, {0.2, 0.0});
  }
  EXPECT_NEAR(body.speed_mps(), 0.0, 1e-9);
  EXPECT_NEAR(body.hold().force_n, 75.0, 1e-6);
}

TEST(Body, IsWedgedBetweenTwoJawsAndFreeAgainInReverse) {
  const WallIndex walls(gated_corridor(2.0, 1.0, 0.44).world, kSensingRange);
  Body body({}, walls, kBodyRadius, {{0.5, 0.003}, 0.0});
  for (int i = 0; i < 500; ++i) {
    body.advance(0.01, {0.2, 0.0});
  }
  // A disc of 0.225 m between corners 0.44 m apart: its middle is sqrt(0.225^2 - 0.22^2) before
  // them.
  const double before = std::sqrt(0.225 * 0.225 - 0.22 * 0.22);
  EXPECT_NEAR(body.pose().position.x_m, 0.925 - before, 1e-6);
  EXPECT_NEAR(body.pose().position.y_m, 0.0, 1e-6);
  EXPECT_NEAR(body.hold().force_n, 300.0 * 0.2 + 15.0, 1e-6);
  EXPECT_EQ(body.speed_mps(), 0.0);
  for (int i = 0; i < 300; ++i) {
    body.advance(0.01, {-0.2, 0.0});
  }
  EXPECT_LT(body.pose().position.x_m, 0.4);
}

}  // namespace
}  // namespace tcert
