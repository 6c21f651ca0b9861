#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <tcert/ray_sweep.hpp>
#include <vector>

namespace tcert {
namespace {

constexpr double kReach = 0.6;
constexpr SweepRule kRule{0.02, 0.01, 0.08, 0.5};

// A world of discs and upright boxes at least 0.08 m wide.
struct Walls {
  struct Box {
    Point low, high;
  };
  std::vector<Point> centres;
  std::vector<double> radii;
  std::vector<Box> boxes;

  [[nodiscard]] bool occupied(Point p) const {
    for (std::size_t i = 0; i < centres.size(); ++i) {
      if (distance(p, centres[i]) < radii[i]) {
        return true;
      }
    }
    return std::any_of(boxes.begin(), boxes.end(), [p](const Box& b) {
      return p.x_m > b.low.x_m && p.x_m < b.high.x_m && p.y_m > b.low.y_m && p.y_m < b.high.y_m;
    });
  }
  [[nodiscard]] bool clear_within(Point p, double radius) const {
    for (std::size_t i = 0; i < centres.size(); ++i) {
      if (distance(p, centres[i]) < radii[i] + radius) {
        return false;
      }
    }
    return std::none_of(boxes.begin(), boxes.end(), [&](const Box& b) {
      const double dx = std::max({b.low.x_m - p.x_m, 0.0, p.x_m - b.high.x_m});
      const double dy = std::max({b.low.y_m - p.y_m, 0.0, p.y_m - b.high.y_m});
      return std::hypot(dx, dy) < radius;
    });
  }
  [[nodiscard]] double cast(Point from, Point u) const {
    double r = 0.0;
    while (r < kReach && !occupied(from + r * u)) {
      r += 2e-4;
    }
    return std::max(0.0, std::min(r, kReach) - 2e-4);
  }
};

Walls random_walls(std::mt19937& engine) {
  const auto uniform = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  Walls walls;
  for (int k = 0; k < 8; ++k) {
    const Point at{uniform(-1.0, 1.0), uniform(-1.0, 1.0)};
    if (k % 2 == 0) {
      walls.centres.push_back(at);
      walls.radii.push_back(uniform(0.04, 0.15));
    } else {
      walls.boxes.push_back({at, at + Point{uniform(0.08, 0.3), uniform(0.08, 0.3)}});
    }
  }
  return walls;
}

template <typename Visit>
void for_each_marked(const SweptCells& cells, Visit visit) {
  for (std::int32_t iy = -120; iy < 120; ++iy) {
    for (std::int32_t ix = -120; ix < 120; ++ix) {
      if (cells.contains({ix, iy})) {
        visit(ix, iy);
      }
    }
  }
}

// With mounts in the open and with mounts deep in a body, wherever a body that deep has room.
std::size_t expect_no_touched_cell(const SweepRule& rule, bool has_body) {
  std::size_t marked = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 engine(seed);
    const auto uniform = [&engine](double low, double high) {
      return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
    };
    const Walls walls = random_walls(engine);
    const double bearing = uniform(-std::numbers::pi, std::numbers::pi);
    const Point local{uniform(-0.1, 0.15), uniform(-0.1, 0.1)};
    Pose pose{{uniform(-0.8, 0.8), uniform(-0.8, 0.8)}, uniform(-3.0, 3.0)};
    double turn_per_m = 0.0;
    RaySweep sweep;
    SweptCells cells(1U << 16U);
    for (int k = 0; k < 120; ++k) {
      turn_per_m = engine() % 20 == 0 ? uniform(-4.0, 4.0) : turn_per_m;
      const double step_m = (engine() % 30 == 0 ? -1.0 : 1.0) * uniform(0.0, 0.03);
      pose.yaw_rad += turn_per_m * step_m;
      pose.position = pose.position + step_m * direction(pose.yaw_rad);
      const Point mount = transform(pose, local);
      // Of a body that is free; a mount inside of an obstacle is no ray.
      const Point u = direction(pose.yaw_rad + bearing);
      const bool in_body =
          has_body && walls.clear_within(mount, rule.lost_share * rule.least_obstacle_m);
      if (walls.occupied(mount) || engine() % 40 == 0) {
        sweep.advance(mount, u, std::nan(""), in_body, rule, cells);
      } else {
        sweep.advance(mount, u, walls.cast(mount, u), in_body, rule, cells);
      }
    }
    for_each_marked(cells, [&](std::int32_t ix, std::int32_t iy) {
      ++marked;
      for (int i = 0; i <= 4; ++i) {
        for (int j = 0; j <= 4; ++j) {
          const Point p{(ix + 0.25 * i) * rule.cell_m, (iy + 0.25 * j) * rule.cell_m};
          EXPECT_FALSE(walls.occupied(p)) << "seed " << seed << " at " << p.x_m << ", " << p.y_m;
        }
      }
    });
    if (testing::Test::HasFailure()) {
      return marked;
    }
  }
  return marked;
}

TEST(RaySweep, MarksNoCellThatAnObstacleTouches) {
  const std::size_t open = expect_no_touched_cell(kRule, false);
  EXPECT_GT(open, 6'000U);
  EXPECT_GT(expect_no_touched_cell(kRule, true), open);
  SweepRule sharp = kRule;
  sharp.lost_share = 0.5 / std::tan(std::numbers::pi / 12.0);  // wedges of 30 degrees
  const std::size_t sharp_open = expect_no_touched_cell(sharp, false);
  EXPECT_GT(sharp_open, 1'000U);
  EXPECT_LT(sharp_open, open);
  EXPECT_GT(expect_no_touched_cell(sharp, true), sharp_open);
}

// A ray square to a straight way, free all along: everything that it passed, less the loss.
TEST(RaySweep, MarksWhatItPasses) {
  RaySweep sweep;
  SweptCells cells(1U << 16U);
  for (int k = 0; k <= 60; ++k) {
    sweep.advance({0.005 + 0.015 * k, -0.005}, {0.0, 1.0}, 0.5, true, kRule, cells);
  }
  // From 0.005 to 0.905; -0.005 to 0.495 less half of 0.015.
  for (std::int32_t iy = -2; iy < 30; ++iy) {
    for (std::int32_t ix = -2; ix < 50; ++ix) {
      const bool inside = ix >= 1 && ix < 45 && iy >= 0 && iy < 24;
      ASSERT_EQ(cells.contains({ix, iy}), inside) << ix << ", " << iy;
    }
  }
}

TEST(RaySweep, MarksTheSameFromTheOtherSide) {
  RaySweep there;
  RaySweep back;
  SweptCells cells(1U << 16U);
  SweptCells cells_back(1U << 16U);
  for (int k = 0; k <= 60; ++k) {
    there.advance({0.005 + 0.015 * k, -0.005}, {0.0, 1.0}, 0.5, true, kRule, cells);
    back.advance({0.905 - 0.015 * k, -0.005}, {0.0, 1.0}, 0.5, true, kRule, cells_back);
  }
  std::size_t marked = 0;
  for_each_marked(cells, [&](std::int32_t ix, std::int32_t iy) {
    ++marked;
    EXPECT_TRUE(cells_back.contains({ix, iy}));
  });
  EXPECT_EQ(marked, 44U * 24U);
}

TEST(RaySweep, SweepsNothingBetweenReadingsFurtherApartThanAnObstacle) {
  RaySweep sweep;
  SweptCells cells(1U << 16U);
  for (int k = 0; k <= 10; ++k) {
    sweep.advance({0.09 * k, 0.0}, {0.0, 1.0}, 0.5, true, kRule, cells);
  }
  for_each_marked(cells, [](std::int32_t ix, std::int32_t iy) { FAIL() << ix << ", " << iy; });
}

// What was read while the ray hardly moved counts too.
TEST(RaySweep, KeepsTheSmallestClearanceOfReadingsThatItSkips) {
  RaySweep sweep;
  SweptCells cells(1U << 16U);
  for (int k = 0; k <= 60; ++k) {
    sweep.advance({0.005 * k, 0.0}, {0.0, 1.0}, k == 31 ? 0.1 : 0.5, true, kRule, cells);
  }
  EXPECT_TRUE(cells.contains({2, 15}));
  EXPECT_FALSE(cells.contains({7, 15}));  // 0.14 to 0.16
  EXPECT_TRUE(cells.contains({12, 15}));
}

}  // namespace
}  // namespace tcert
