#include "analysis/study/truth/curvature_value.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/study/truth/curvature_search.hpp"
#include "analysis/study/truth/random_worlds.hpp"
#include "analysis/study/truth/truth.hpp"

namespace tcert::study {
namespace {

constexpr double kPi = std::numbers::pi;

Robot robot(double body_width, double min_radius) {
  Robot result;
  result.body_width_m = body_width;
  result.min_turn_radius_m = min_radius;
  return result;
}

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// Every arc begins where the last ends, the first in S; the last ends in G.
void expect_joined(const World& world, const std::vector<Arc>& path) {
  ASSERT_FALSE(path.empty());
  EXPECT_TRUE(contains(*world.start, path.front().from.position));
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Pose end = pose_at(path[i], path[i].length_m);
    EXPECT_NEAR(distance(end.position, path[i + 1].from.position), 0.0, 1e-9);
    EXPECT_NEAR(angle_between(end.yaw_rad, path[i + 1].from.yaw_rad), 0.0, 1e-9);
  }
  EXPECT_TRUE(contains(*world.goal, pose_at(path.back(), path.back().length_m).position));
}

World corridor_with_gate(double width, double gate) {
  World world;
  world.name = "gate";
  world.bounds = {{0.0, 0.0}, {6.0, width}};
  world.start = Disc{{0.6, 0.5 * width}, 0.2};
  world.goal = Disc{{5.4, 0.5 * width}, 0.2};
  world.obstacles = {box(2.9, -0.1, 3.1, 0.5 * (width - gate)),
                     box(2.9, 0.5 * (width + gate), 3.1, width + 0.1)};
  return world;
}

TEST(CurvatureValue, AGateInACorridor) {
  const World world = corridor_with_gate(1.2, 0.63);
  const Truth truth = truth_of(world, robot(0.45, 0.35));
  const double exact = 0.63 - 0.45;
  EXPECT_LE(truth.lower_m, exact);
  EXPECT_GE(truth.upper_m, exact);
  EXPECT_LE(truth.upper_m - exact, 4.0 * std::sqrt(2.0) * 0.02);
  EXPECT_GE(truth.lower_m, exact - 0.05);
  expect_joined(world, truth.path);
}

/// Half an annulus: from the left end of the upper half round to the right end.
World annulus(double a, double b) {
  World world;
  world.name = "annulus";
  world.bounds = {{-b - 0.1, -b - 0.1}, {b + 0.1, b + 0.1}};
  const double middle = 0.5 * (a + b);
  world.start = Disc{{-middle, 0.0}, 0.5 * (b - a) - 0.001};
  world.goal = Disc{{middle, 0.0}, 0.5 * (b - a) - 0.001};
  world.obstacles.emplace_back(Disc{{0.0, 0.0}, a});
  for (const double sign : {1.0, -1.0}) {
    Polygon outside;
    for (int i = 0; i <= 180; ++i) {
      outside.vertices.push_back(b / std::cos(kPi / 360) * direction(sign * kPi * i / 180));
    }
    outside.vertices.push_back({-b - 1.0, 0.0});
    outside.vertices.push_back({-b - 1.0, sign * (b + 1.0)});
    outside.vertices.push_back({b + 1.0, sign * (b + 1.0)});
    outside.vertices.push_back({b + 1.0, 0.0});
    world.obstacles.emplace_back(outside);
  }
  return world;
}

TEST(CurvatureValue, AnAnnulusWideEnoughToTurnIn) {
  // (a + b) / 2 - R_min >= b - a - w_B: the middle circle is best.
  const double a = 0.8;
  const double b = 1.6;
  const World world = annulus(a, b);
  const Truth truth = truth_of(world, robot(0.45, 0.35));
  const double exact = b - a - 0.45;
  EXPECT_LE(truth.lower_m, exact + 1e-3);
  EXPECT_GE(truth.upper_m, exact - 1e-3);
  EXPECT_GE(truth.lower_m, exact - 0.08);
  expect_joined(world, truth.path);
}

/// Two corridors of width w side by side; the thin wall between them ends 1.5 m before the end.
World u_turn(double width) {
  World world;
  world.name = "U-turn";
  constexpr double kLength = 3.0;
  constexpr double kThin = 1e-3;
  world.bounds = {{0.0, 0.0}, {kLength + 1.5, 2.0 * width}};
  world.start = Disc{{0.3, 0.5 * width}, 0.05};
  world.goal = Disc{{0.3, 1.5 * width}, 0.05};
  world.obstacles = {box(-1.0, width - 0.5 * kThin, kLength, width + 0.5 * kThin)};
  return world;
}

TEST(CurvatureValue, TheUTurnIsNegativeWhereTheBodyFitsButCannotTurn) {
  const Robot body = robot(0.45, 0.35);
  for (const double width : {0.5, 0.55, 0.65, 0.8}) {
    const World world = u_turn(width);
    double exact = -1.0;
    for (double delta = 0.0; delta <= 0.5 * width; delta += 1e-5) {
      exact = std::max(
          exact, std::min(2.0 * delta - body.body_width_m, width - delta - body.min_turn_radius_m));
    }
    const Truth truth = truth_of(world, body);
    EXPECT_LE(truth.lower_m, exact + 2e-3) << width;  // the wall is 1 mm thick
    EXPECT_GE(truth.upper_m, exact - 2e-3) << width;
    EXPECT_GE(truth.lower_m, exact - 0.015) << width;
    EXPECT_GT(clearance_value(world, 0.02).clearance_m, 0.5 * body.body_width_m - 0.03) << width;
  }
}

// The lattice of the search has no path round the corner at R_min = 2 m; at 1.2 m it has one that is
// worth 0.08 m less.
TEST(CurvatureValue, StretchingThePathOnlyRaisesTheBound) {
  World world;
  world.name = "corner";
  world.bounds = {{0.0, 0.0}, {4.0, 4.0}};
  world.start = Disc{{0.5, 0.5}, 0.2};
  world.goal = Disc{{3.5, 3.5}, 0.2};
  world.obstacles = {box(-0.1, 1.0, 3.0, 4.1)};
  TruthOptions plain;
  plain.path_cell_m = 0.0;
  for (const double min_radius : {0.35, 1.2, 2.0}) {
    const Truth lattice = truth_of(world, robot(0.45, min_radius), plain);
    const Truth stretched = truth_of(world, robot(0.45, min_radius));
    EXPECT_GE(stretched.lower_m, lattice.lower_m);
    EXPECT_LE(stretched.lower_m, stretched.upper_m);
    if (min_radius > 1.0) {
      EXPECT_GT(stretched.lower_m, lattice.lower_m + 0.05) << min_radius;
      expect_joined(world, stretched.path);
    }
  }
}

/// A wall of discs with gaps that the body does not fit, from border to border.
World fence() {
  World world;
  world.name = "fence";
  world.bounds = {{0.0, 0.0}, {4.0, 4.0}};
  world.start = Disc{{1.0, 1.0}, 0.3};
  world.goal = Disc{{3.0, 1.0}, 0.3};
  for (int i = 0; i < 11; ++i) {
    world.obstacles.emplace_back(Disc{{2.0, 0.05 + 0.28 * i}, 0.2});
  }
  return world;
}

// A slack of clearance 0 is -w_B by width, but -w_B / 2 radially; a path below it leaves the
// bounds.
TEST(CurvatureValue, StaysWithinTheBoundsInEitherConvention) {
  for (const auto convention : {SlackConvention::width, SlackConvention::radial}) {
    const World world = fence();
    for (const double min_radius : {0.35, 5.0}) {
      TruthOptions options;
      options.convention = convention;
      const Truth truth = truth_of(world, robot(0.45, min_radius), options);
      EXPECT_LE(truth.lower_m, truth.upper_m);
      for (const Arc& arc : truth.path) {
        for (const double share : {0.0, 0.5, 1.0}) {
          const Point p = pose_at(arc, share * arc.length_m).position;
          EXPECT_TRUE(p.x_m >= 0.0 && p.y_m >= 0.0 && p.x_m <= 4.0 && p.y_m <= 4.0);
        }
      }
    }
  }
}

// 1.3e8 poses would take some 4 GB.
TEST(CurvatureValue, RefusesASearchThatWouldTakeAllMemory) {
  const World world = corridor_with_gate(1.2, 0.63);
  const ObstacleDistance obstacles(world);
  const ClearanceTable table(world, obstacles, 0.05);
  CurvatureQuery query;
  query.cell_m = 0.0016;
  EXPECT_THROW((void)search_path(world, table, {}, query), std::invalid_argument);
}

TEST(CurvatureValue, LiesBelowTheExactClearanceInRandomWorlds) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    const World world = test_support::random_disc_world(i, i % 2 == 0);
    const Truth truth = truth_of(world, robot(0.2, 0.15));
    EXPECT_LE(truth.lower_m, truth.upper_m) << world.name;
    if (std::isfinite(truth.lower_m)) {
      expect_joined(world, truth.path);
    }
  }
}

}  // namespace
}  // namespace tcert::study
