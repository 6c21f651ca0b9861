#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <witness/free_space.hpp>

#include "lib/witness/walls.hpp"

namespace tcert::witness {
namespace {

const Disc kStart{{0.0, 0.0}, 0.05};

/// Points of a cell: its corners, just inside, and its middle.
std::vector<Point> points_of(const Lattice& lattice, int ix, int iy) {
  std::vector<Point> points;
  const Point low = lattice.corner(ix, iy);
  for (const double x : {1e-9, 0.5, 1.0 - 1e-9}) {
    for (const double y : {1e-9, 0.5, 1.0 - 1e-9}) {
      points.push_back(low + lattice.cell_m * Point{x, y});
    }
  }
  return points;
}

// In worlds that keep the rule for obstacles, no cell that is said to be free touches a wall.
TEST(FreeSpace, LiesWithinTheTrueFreeSpace) {
  const Robot robot = small_robot();
  std::size_t free = 0;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    std::mt19937 engine(seed);
    const Walls walls = random_walls(engine);
    const Samples samples = random_drive(walls, robot, engine, 300);
    const FreeCells cells = free_space(robot, {kStart, std::nullopt}, samples, {});
    const Lattice& lattice = cells.lattice();
    for (int iy = 0; iy < lattice.rows; ++iy) {
      for (int ix = 0; ix < lattice.columns; ++ix) {
        if (!cells.is_free(ix, iy)) {
          continue;
        }
        ++free;
        for (const Point p : points_of(lattice, ix, iy)) {
          ASSERT_GT(walls.distance_from(p), -1e-6)
              << "seed " << seed << " at " << p.x_m << ' ' << p.y_m;
        }
      }
    }
  }
  EXPECT_GT(free, 25U * 5000U);  // at 25 mm^2 a cell: more than the body's disc
}

/// True if `p` lies between two positions of a ray, less what is taken off: by brute force over all
/// pairs of readings, with no thought of order or of cells.
bool between_any_two(const Samples& samples, const Robot& robot, const StripRule& rule, Point p) {
  for (std::size_t k = 0; k < robot.rays.size(); ++k) {
    const Ray& ray = robot.rays[k];
    const double gap_m = 0.5 * robot.body_width_m - norm(ray.mount);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      for (std::size_t j = i + 1; j < std::min(i + 60, samples.size()); ++j) {
        const Point a = transform(samples.poses[i], ray.mount);
        const Point b = transform(samples.poses[j], ray.mount);
        const Point u = direction(samples.poses[i].yaw_rad + ray.bearing_rad);
        const Point v = direction(samples.poses[j].yaw_rad + ray.bearing_rad);
        const double least_m = std::min(samples.clearances_m[i * samples.rays + k],
                                        samples.clearances_m[j * samples.rays + k]);
        const double d = std::max(distance(a, b), norm((b - a) + least_m * (v - u)));
        if (d > rule.least_obstacle_m || dot(u, v) < 0.5) {
          continue;
        }
        const Point middle = (1.0 / norm(u + v)) * (u + v);
        const double lost_m = rule.lost_share * d;
        const double from_m =
            std::max(dot(middle, a), dot(middle, b)) + (gap_m >= lost_m ? 0.0 : lost_m);
        const double to_m =
            std::min(dot(middle, a), dot(middle, b)) + least_m * dot(u, middle) - lost_m;
        const double depth_m = dot(middle, p);
        const bool between = cross(u, p - a) * cross(v, p - b) <= 0.0;
        if (between && depth_m >= from_m - 1e-9 && depth_m <= to_m + 1e-9) {
          return true;
        }
      }
    }
  }
  return false;
}

TEST(FreeSpace, IsWhatSomePairOfReadingsCovers) {
  const Robot robot = small_robot();
  std::size_t checked = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 engine(seed);
    const Walls walls = random_walls(engine);
    const Samples samples = random_drive(walls, robot, engine, 120);
    const FreeSpaceOptions options{0.01, {}, 1U << 24U};
    const FreeCells cells = free_space(robot, {kStart, std::nullopt}, samples, options);
    const Lattice& lattice = cells.lattice();
    for (int iy = 0; iy < lattice.rows; ++iy) {
      for (int ix = static_cast<int>(engine() % 7U); ix < lattice.columns; ix += 7) {
        if (!cells.is_free(ix, iy)) {
          continue;
        }
        const Point p = points_of(lattice, ix, iy)[engine() % 9U];
        const bool in_body = std::ranges::any_of(samples.poses, [&](const Pose& pose) {
          return distance(pose.position, p) <= 0.5 * robot.body_width_m;
        });
        if (!in_body && norm(p) > kStart.radius_m) {
          ++checked;
          ASSERT_TRUE(between_any_two(samples, robot, options.strips, p))
              << "seed " << seed << " at " << p.x_m << ' ' << p.y_m;
        }
      }
    }
  }
  EXPECT_GT(checked, 50U);
}

Samples turn_on_the_spot(const Robot& robot, double sense) {
  Samples samples;
  samples.rays = robot.rays.size();
  for (int i = 0; i < 160; ++i) {
    samples.poses.push_back({{0.0, 0.0}, sense * 0.04 * i});
    samples.breaks.push_back(0);
    samples.clearances_m.insert(samples.clearances_m.end(), robot.rays.size(), 0.5);
  }
  return samples;
}

// A ray whose mount lies on the axis does not move there, and yet sees all round: its share of the
// disc is what a turn of 2 pi sweeps, less what is lost at the tip.
TEST(FreeSpace, ARayOnTheAxisProvesItsDiscInATurn) {
  Robot robot;
  robot.body_width_m = 0.1;
  robot.rays = {range_ray("axis", {0.0, 0.0}, 0.0, 0.5)};
  for (const double sense : {1.0, -1.0}) {
    const FreeCells cells =
        free_space(robot, {kStart, std::nullopt}, turn_on_the_spot(robot, sense), {});
    const double area = 25e-6 * static_cast<double>(cells.count());
    EXPECT_GT(area, 0.95 * std::numbers::pi * 0.49 * 0.49);
    EXPECT_LT(area, std::numbers::pi * 0.5 * 0.5);
  }
}

TEST(FreeSpace, AReadingBoundShortensWhatIsProven) {
  Robot robot;
  robot.body_width_m = 0.1;
  robot.rays = {range_ray("axis", {0.0, 0.0}, 0.0, 0.5)};
  FreeSpaceOptions options;
  const Samples samples = turn_on_the_spot(robot, 1.0);
  const std::size_t all = free_space(robot, {kStart, std::nullopt}, samples, options).count();
  options.strips.reading_bound_m = 0.05;
  const std::size_t fewer = free_space(robot, {kStart, std::nullopt}, samples, options).count();
  EXPECT_NEAR(static_cast<double>(fewer) / static_cast<double>(all), 0.81, 0.02);  // (0.45 / 0.5)^2
}

// Readings further apart than the least obstacle prove nothing between them.
TEST(FreeSpace, AGapOfMoreThanTheLeastObstacleIsNotBridged) {
  Robot robot;
  robot.body_width_m = 0.1;
  robot.rays = {range_ray("left", {0.0, 0.0}, 0.5 * std::numbers::pi, 0.5)};
  Samples samples;
  samples.rays = 1;
  for (const double x : {0.0, 0.02, 0.04, 0.13, 0.15}) {
    samples.poses.push_back({{x, 0.0}, 0.0});
    samples.breaks.push_back(0);
    samples.clearances_m.push_back(0.5);
  }
  const FreeCells cells = free_space(robot, {kStart, std::nullopt}, samples, {});
  const auto is_free = [&](double x, double y) {
    return cells.is_free(cells.lattice().column_of(x), cells.lattice().row_of(y));
  };
  EXPECT_TRUE(is_free(0.022, 0.3));
  EXPECT_FALSE(is_free(0.08, 0.3));
  EXPECT_TRUE(is_free(0.142, 0.3));
}

TEST(FreeSpace, ABoxOfTooManyCellsIsRefused) {
  const Robot robot = small_robot();
  Samples samples = turn_on_the_spot(robot, 1.0);
  samples.poses.back().position = {1e6, 1e6};
  EXPECT_THROW((void)free_space(robot, {kStart, std::nullopt}, samples, {}), std::length_error);
}

}  // namespace
}  // namespace tcert::witness
