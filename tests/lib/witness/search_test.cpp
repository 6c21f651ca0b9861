#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <witness/polygon.hpp>
#include <witness/search.hpp>

#include "lib/witness/cells.hpp"

namespace tcert::witness {
namespace {

FreeCells free_where(Point low, Point high, const std::function<bool(Point, Point)>& is_free) {
  return cells_where(low, high, [&](Point middle) {
    return is_free(middle, {0.5 * kCell, 0.5 * kCell});
  });
}

double found_margin(const FreeCells& cells,
                    const Region& start,
                    const Region& goal,
                    const Robot& robot) {
  const Found found = search(SearchSpace(cells), start, goal, robot, {}, 600);
  EXPECT_TRUE(found.witness) << found.reason;
  if (!found.witness) {
    return -1.0;
  }
  const Checked again = check(found.witness->path, cells, start, goal, robot);
  EXPECT_EQ(again.margin_m, found.witness->checked.margin_m);
  return again.margin_m;
}

// T of a straight corridor with a gate off its middle is the gate's width less the body's.
TEST(Search, FindsTheGateOfACorridor) {
  for (const double gate_m : {0.5, 0.62, 0.8}) {
    const FreeCells cells = free_where({0, 0}, {4, 1.4}, [&](Point p, Point) {
      const bool in_gate_row = std::abs(p.x_m - 2.0) < 0.05;
      return p.x_m > 0 && p.x_m < 4 && p.y_m > 0 && p.y_m < 1.4 &&
             (!in_gate_row || std::abs(p.y_m - 0.85) < 0.5 * gate_m);
    });
    const double margin_m =
        found_margin(cells, Disc{{0.6, 0.7}, 0.1}, Disc{{3.4, 0.7}, 0.1}, robot_of(0.45, 0.35));
    EXPECT_LE(margin_m, gate_m - 0.45 + 1e-9);
    EXPECT_GT(margin_m, gate_m - 0.45 - 0.004) << gate_m;
  }
}

// Round the end of a wall of thickness t between corridors of width w, T is the largest
// min(2 (d - r_B), w + t / 2 - d - R_min) over d <= w / 2: to turn by half at a radius r takes 2 r
// across. The search falls at most 20 mm short of it.
TEST(Search, ComesNearTheExactTruthOfUTurns) {
  for (const double corridor_m : {0.55, 0.62, 0.7, 0.8, 0.9}) {
    const double wall_m = 0.1;
    const double outer_m = corridor_m + 0.5 * wall_m;
    const FreeCells cells = free_where({-2, -outer_m}, {1.2, outer_m}, [&](Point p, Point h) {
      return std::abs(p.y_m) + h.y_m <= outer_m && p.x_m > -2 && p.x_m < 1.2 &&
             (p.x_m > 0 || std::abs(p.y_m) - h.y_m >= 0.5 * wall_m - 1e-9);
    });
    const Robot robot = robot_of(0.45, 0.35);
    const double room_m = outer_m - robot.min_turn_radius_m;
    const double d = std::min((room_m + robot.body_width_m) / 3.0, 0.5 * corridor_m);
    const double exact_m = std::min(2.0 * d - robot.body_width_m, room_m - d);
    const double middle_m = 0.5 * (wall_m + corridor_m);
    const double margin_m =
        found_margin(cells, Disc{{-1.6, -middle_m}, 0.1}, Disc{{-1.6, middle_m}, 0.1}, robot);
    EXPECT_LE(margin_m, exact_m + 1e-9) << corridor_m;
    EXPECT_GT(margin_m, exact_m - 0.020) << corridor_m;
  }
}

TEST(Search, SaysWhyThereIsNone) {
  const FreeCells cells = free_where({0, 0}, {4, 1}, [](Point p, Point) {
    return p.x_m > 0 && p.x_m < 4 && p.y_m > 0 && p.y_m < 1 && std::abs(p.x_m - 2.0) > 0.1;
  });
  const Region start = Disc{{0.6, 0.5}, 0.1};
  const Region goal = Disc{{3.4, 0.5}, 0.1};
  EXPECT_EQ(search(SearchSpace(cells), start, goal, robot_of(0.45, 0.35), {}, 600).reason,
            "no route from S to G is as wide as the body");
  EXPECT_EQ(search(SearchSpace(cells), start, start, robot_of(0.45, 0.35), {}, 600).reason,
            "S and G overlap");
}

TEST(Search, ItsBitsDoNotDependOnHowOftenItRuns) {
  const FreeCells cells = free_where({0, 0}, {3, 3}, [](Point p, Point) {
    return (p.x_m > 0 && p.x_m < 3 && p.y_m > 0 && p.y_m < 0.8) ||
           (p.x_m > 0 && p.x_m < 0.8 && p.y_m > 0 && p.y_m < 3);
  });
  const Region start = Disc{{0.4, 2.5}, 0.1};
  const Region goal = Disc{{2.5, 0.4}, 0.1};
  const Found one = search(SearchSpace(cells), start, goal, robot_of(0.45, 0.35), {}, 300);
  const Found two = search(SearchSpace(cells), start, goal, robot_of(0.45, 0.35), {}, 300);
  ASSERT_TRUE(one.witness && two.witness);
  EXPECT_EQ(one.witness->path, two.witness->path);
}

TEST(Polygon, APathIsTangentAndKeepsTheRadius) {
  std::vector<Point> polygon;
  for (int i = 0; i <= 60; ++i) {
    const double angle = 0.05 * i;
    polygon.push_back({std::cos(angle), std::sin(angle)});
  }
  const Path path = path_of(polygon);
  EXPECT_EQ(path.front().from, polygon.front());
  EXPECT_EQ(path.back().to, polygon.back());
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      EXPECT_EQ(path[i].from, path[i - 1].to);
      EXPECT_LT(std::abs(angle_between(heading_to(path[i - 1]), heading_from(path[i]))), 1e-9);
    }
    if (path[i].turn_rad != 0.0) {
      EXPECT_NEAR(radius(path[i]), 1.0, 2e-3);
    }
  }
  EXPECT_EQ(refined(polygon).size(), 2 * polygon.size());
}

}  // namespace
}  // namespace tcert::witness
