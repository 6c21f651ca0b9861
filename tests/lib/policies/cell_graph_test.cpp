#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <tcert/cell_graph.hpp>
#include <vector>

#include "lib/policies/felt_run.hpp"
#include "support/shortest_oracle.hpp"

namespace tcert::policies {
namespace {

using test_support::CostedEdge;

// 21 x 13 cells of 0.1 m, the middle one (0, 0); a body of 0.3 m, inflated by 0.1 m.
PolicySetup small_course() {
  PolicySetup setup = two_lobes();
  setup.robot.body_width_m = 0.3;
  setup.line.lobes.clear();
  setup.line.low = {-0.9, -0.5};
  setup.line.high = {0.9, 0.5};
  setup.parameters.policy_cell_m = 0.1;
  setup.parameters.inflation_slack_m = 0.05;
  return setup;
}

// The same graph, made anew from what was set.
class Oracle {
 public:
  explicit Oracle(const CourseGrid& grid)
      : grid_(grid), obstacle_(grid.cells()), level_(grid.cells()) {}

  std::vector<bool> obstacle() const { return obstacle_; }
  void set_obstacle(std::uint32_t cell, bool obstacle) { obstacle_[cell] = obstacle; }
  void set_level(std::uint32_t cell, std::uint8_t level) { level_[cell] = level; }

  bool is_free(std::uint32_t cell) const {
    for (std::uint32_t other = 0; other < grid_.cells(); ++other) {
      const GridCell a = grid_.cell(cell);
      const GridCell b = grid_.cell(other);
      if (obstacle_[other] && std::hypot(a.x - b.x, a.y - b.y) * 0.1 <= 0.1 + 1e-9) {
        return false;
      }
    }
    return true;
  }

  std::vector<PathCost> costs(std::uint32_t goal) const {
    std::vector<bool> free(grid_.cells());
    for (std::uint32_t cell = 0; cell < grid_.cells(); ++cell) {
      free[cell] = is_free(cell);
    }
    std::vector<CostedEdge> edges;
    for (std::uint32_t a = 0; a < grid_.cells(); ++a) {
      for (const GridCell step : {GridCell{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
        const std::uint32_t b = grid_.index(grid_.cell(a) + step);
        if (b == CourseGrid::kOutside || !free[a] || !free[b]) {
          continue;
        }
        const double length_um = 1e5 * (step.x != 0 && step.y != 0 ? std::numbers::sqrt2 : 1.0);
        const double dearer = 1.0 + 3.0 * (level_[a] + level_[b]) / 16.0;
        edges.push_back({{a, b}, static_cast<PathCost>(std::ceil(length_um * dearer)) + 2});
      }
    }
    return test_support::costs_by_dijkstra(grid_.cells(), edges, goal);
  }

 private:
  const CourseGrid& grid_;
  std::vector<bool> obstacle_;
  std::vector<std::uint8_t> level_;
};

TEST(CellGraph, EqualsDijkstraAfterEveryChange) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 engine(seed);
    CellGraph graph(small_course());
    Oracle oracle(graph.grid());
    const auto cells = graph.grid().cells();
    const auto goal = static_cast<std::uint32_t>(engine() % cells);
    graph.set_goal(goal);
    for (int change = 0; change < 12; ++change) {
      for (int i = 0; i < 4; ++i) {
        const auto cell = static_cast<std::uint32_t>(engine() % cells);
        const bool obstacle = engine() % 3 != 0;
        graph.set_obstacle(cell, obstacle);
        oracle.set_obstacle(cell, obstacle);
        const auto soft = static_cast<std::uint32_t>(engine() % cells);
        const auto level = static_cast<std::uint8_t>(engine() % 9);
        graph.set_level(soft, level);
        oracle.set_level(soft, level);
      }
      const auto costs = oracle.costs(goal);
      for (int i = 0; i < 3; ++i) {
        const auto start = static_cast<std::uint32_t>(engine() % cells);
        ASSERT_EQ(graph.is_free(start), oracle.is_free(start));
        ASSERT_EQ(graph.plan(start), costs[start]);
      }
    }
  }
}

// The way that `ahead` follows costs what the plan says: checked where it is free to reach the
// goal.
TEST(CellGraph, FollowsAWayOfLeastCost) {
  CellGraph graph(small_course());
  const CourseGrid& grid = graph.grid();
  const std::uint32_t goal = grid.index({7, 0});
  graph.set_goal(goal);
  Oracle oracle(grid);
  for (const int y : {-3, -2, -1, 0, 1}) {
    graph.set_obstacle(grid.index({2, y}), true);
    oracle.set_obstacle(grid.index({2, y}), true);
  }
  const auto costs = oracle.costs(goal);
  std::uint32_t at = grid.index({-7, 0});
  for (int step = 0; at != goal; ++step) {
    ASSERT_LT(step, 100);
    ASSERT_EQ(graph.plan(at), costs[at]);
    const std::uint32_t next = grid.index(grid.cell_at(graph.ahead(0.05, 1)));
    const GridCell moved = grid.cell(next);
    const GridCell from = grid.cell(at);
    ASSERT_LE(std::max(std::abs(moved.x - from.x), std::abs(moved.y - from.y)), 1);
    ASSERT_LT(costs[next], costs[at]);
    at = next;
  }
}

TEST(CellGraph, KeepsToTheStraightLineWhereWaysCostTheSame) {
  CellGraph graph(small_course());
  const CourseGrid& grid = graph.grid();
  graph.set_goal(grid.index({7, 4}));
  ASSERT_NE(graph.plan(grid.index({-7, -3})), kBlocked);
  // Slope 1/2: a way of seven diagonals and seven straights, never half a cell off the line.
  for (int cells = 1; cells <= 10; ++cells) {
    const GridCell at = grid.cell_at(graph.ahead(0.1 * cells, 1));
    EXPECT_LE(std::abs(2 * (at.y + 3) - (at.x + 7)), 1) << cells;
  }
}

TEST(CellGraph, GoesRoundOnTheSideThatWinsTies) {
  CellGraph graph(small_course());
  const CourseGrid& grid = graph.grid();
  graph.set_goal(grid.index({7, 0}));
  graph.set_obstacle(grid.index({0, 0}), true);
  ASSERT_NE(graph.plan(grid.index({-3, 0})), kBlocked);
  const Point left = graph.ahead(0.3, 1);
  const Point right = graph.ahead(0.3, -1);
  EXPECT_GT(left.y_m, 0.0);
  EXPECT_EQ(left, (Point{right.x_m, -right.y_m}));
}

TEST(CellGraph, ResetForgetsObstaclesLevelsAndGoal) {
  CellGraph graph(small_course());
  const CourseGrid& grid = graph.grid();
  const std::uint32_t goal = grid.index({7, 0});
  graph.set_goal(goal);
  const PathCost open = graph.plan(grid.index({-7, 0}));
  for (int y = -8; y <= 8; ++y) {
    const std::uint32_t cell = grid.index({0, y});
    if (cell != CourseGrid::kOutside) {
      graph.set_obstacle(cell, true);
      graph.set_level(cell, 8);
    }
  }
  EXPECT_EQ(graph.plan(grid.index({-7, 0})), kBlocked);
  graph.reset();
  graph.set_goal(goal);
  EXPECT_EQ(graph.plan(grid.index({-7, 0})), open);
}

}  // namespace
}  // namespace tcert::policies
