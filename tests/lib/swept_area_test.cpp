#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/swept_area.hpp>

#include "support/random_run.hpp"

namespace tcert {
namespace {

constexpr double kCell = 0.02;

Robot robot_with_rays() {
  Robot robot;
  robot.rays = {{"left", {0.16, 0.12}, 0.5 * std::numbers::pi, 0.45, RayKind::range, {}},
                {"right", {0.16, -0.12}, -0.5 * std::numbers::pi, 0.45, RayKind::range, {}}};
  return robot;
}

// Of the two rays above.
constexpr std::array<double, 2> kBearings{0.5 * std::numbers::pi, -0.5 * std::numbers::pi};

double distance_to_cell(SweptCell cell, Point p) {
  const double dx = std::max({cell.ix * kCell - p.x_m, 0.0, p.x_m - (cell.ix + 1) * kCell});
  const double dy = std::max({cell.iy * kCell - p.y_m, 0.0, p.y_m - (cell.iy + 1) * kCell});
  return std::hypot(dx, dy);
}

TEST(SweptArea, ClearanceEqualsASearchOfAllCells) {
  const Robot robot = robot_with_rays();
  Course course;
  course.goal = Polygon{{{0.9, -0.5}, {1.6, -0.4}, {1.6, 0.5}, {0.8, 0.5}}};
  SweptArea area(robot, course, {});
  area.begin({});
  const std::array<double, 2> clearances{0.3, 0.45};
  for (int k = 0; k < 80; ++k) {
    const double a = 0.015 * k;
    area.sweep({Point{std::sin(a), 1.0 - std::cos(a)}, a}, clearances, kBearings);
  }
  std::vector<SweptCell> unswept;
  for (std::int32_t iy = -80; iy < 80; ++iy) {
    for (std::int32_t ix = -60; ix < 120; ++ix) {
      if (!area.is_free({ix, iy})) {
        unswept.push_back({ix, iy});
      }
    }
  }
  const double reach = 0.2 + 0.45;
  for (int k = 0; k < 80; k += 3) {
    const double a = 0.015 * k;
    const Point from{std::sin(a), 1.0 - std::cos(a)};
    const Point to = from + 0.03 * direction(1.7 * k);
    double nearest = reach;
    for (const SweptCell cell : unswept) {
      if (distance_to_cell(cell, from) > nearest + 0.03) {
        continue;
      }
      for (int i = 0; i <= 200; ++i) {
        nearest = std::min(nearest, distance_to_cell(cell, from + (i / 200.0) * (to - from)));
      }
    }
    const SweptClearance found = area.clearance(from, to);
    EXPECT_NEAR(found.distance_m, nearest, 2e-6);
    EXPECT_EQ(found.nearest.has_value(), nearest < reach);
  }
}

TEST(SweptArea, OfABodyThatStandsIsItsDisc) {
  SweptArea area(robot_with_rays(), {}, {});
  area.begin({{3.0, -2.0}, 1.0});
  const std::array<double, 2> clearances{0.45, 0.45};
  for (int k = 0; k < 10; ++k) {
    area.sweep({{3.0, -2.0}, 1.0}, clearances, kBearings);
  }
  const double found = area.clearance({3.0, -2.0}, {3.0, -2.0}).distance_m;
  EXPECT_LE(found, 0.225);
  EXPECT_GE(found, 0.225 - std::sqrt(2.0) * kCell);
  // Nothing is known ahead; a way that leaves the swept area has no clearance.
  EXPECT_EQ(area.clearance({3.0, -2.0}, {4.0, -2.0}).distance_m, 0.0);
}

TEST(SweptArea, StartAndGoalCountAsSwept) {
  Course course;
  course.start = Disc{{0.0, 0.0}, 0.5};
  course.goal = Polygon{{{1.0, -0.4}, {2.0, -0.4}, {2.0, 0.4}, {1.0, 0.4}}};
  SweptArea area(robot_with_rays(), course, {});
  area.begin({{0.1, 0.1}, 0.3});
  EXPECT_NEAR(area.clearance({0.0, 0.0}, {0.0, 0.0}).distance_m, 0.5 - 0.015, 0.015);
  EXPECT_NEAR(area.clearance({1.5, 0.0}, {1.5, 0.0}).distance_m, 0.4 - 0.015, 0.015);
  EXPECT_EQ(area.clearance({0.7, 0.0}, {0.7, 0.0}).distance_m, 0.0);
}

// Corridor of half-width 0.4, driven in its middle: half a cell's loss and the corner's.
TEST(SweptArea, ReadsACorridorFromBehind) {
  SweptArea area(robot_with_rays(), {}, {});
  area.begin({});
  const std::array<double, 2> clearances{0.28, 0.28};
  for (int k = 0; k <= 120; ++k) {
    area.sweep({{0.016 * k, 0.0}, 0.0}, clearances, kBearings);
  }
  const Point middle{0.96, 0.0};
  EXPECT_LE(area.clearance(middle, middle).distance_m, 0.4 - 0.008);
  EXPECT_GE(area.clearance(middle, middle).distance_m, 0.4 - 0.008 - kCell);
  const Point front{0.016 * 120, 0.0};
  EXPECT_LE(area.clearance(front, front).distance_m, 0.225);
}

}  // namespace
}  // namespace tcert
