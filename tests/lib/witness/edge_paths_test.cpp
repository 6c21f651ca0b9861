#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <witness/chain.hpp>
#include <witness/edge_paths.hpp>
#include <witness/waypoint.hpp>

#include "lib/witness/cells.hpp"

namespace tcert::witness {
namespace {

constexpr double kPi = std::numbers::pi;

Node node_at(Point position, double yaw_rad) {
  return {{position, yaw_rad}, direction(yaw_rad), false, false};
}

Edge edge_between(EdgeEnd from, EdgeEnd to, double felt_m = 0.1) {
  Edge edge;
  edge.ends = {from, to};
  edge.pass.margin_m = felt_m;
  return edge;
}

/// From the front of each node to the back of the next.
std::vector<Edge> in_a_row(std::size_t nodes) {
  std::vector<Edge> edges;
  for (std::uint32_t n = 1; n < nodes; ++n) {
    edges.push_back(edge_between({n - 1, Side::front}, {n, Side::back}));
  }
  return edges;
}

TEST(Lanes, AStubDoesNotTakeTheLaneAndARingIsCut) {
  std::vector<Edge> edges = in_a_row(4);
  edges.push_back(edge_between({1, Side::front}, {4, Side::back}, 0.9));   // a wide dead end
  edges.push_back(edge_between({3, Side::front}, {2, Side::front}, 0.2));  // back into the lane
  const std::vector<Lane> lanes = lanes_of(5, edges);
  // From 2 the widest way on is that into the front of 3, and from the back of 3 to 2, whose front
  // it does not leave by again.
  ASSERT_EQ(lanes.size(), 2U);
  EXPECT_EQ(lanes[0], (Lane{{0, false}, {1, false}, {4, true}, {2, true}}));
  EXPECT_EQ(lanes[1], (Lane{{3, false}}));
  std::vector<Edge> ring = in_a_row(3);
  ring.push_back(edge_between({2, Side::front}, {0, Side::back}));
  EXPECT_EQ(lanes_of(3, ring), (std::vector<Lane>{{{1, false}, {2, false}, {0, false}}}));
}

struct Driven {
  FreeCells cells;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  Region start;
  Region goal;
};

EdgePaths paths_of(const Driven& course, const SearchSpace& space, const Robot& robot) {
  return edge_paths({space, course.nodes, course.edges, course.start, course.goal, robot}, {}, {});
}

/// A corridor 1 m wide, driven 8 cm off its middle.
Driven corridor() {
  Driven made{
      cells_where(
          {0, 0}, {6, 1}, [](Point p) { return p.x_m > 0 && p.x_m < 6 && p.y_m > 0 && p.y_m < 1; }),
      {},
      {},
      Disc{{1, 0.5}, 0.3},
      Disc{{5, 0.5}, 0.3}};
  for (int i = 0; i <= 16; ++i) {
    made.nodes.push_back(node_at({1.0 + 0.25 * i, 0.42}, i % 2 == 0 ? 0.05 : -0.05));
  }
  made.edges = in_a_row(made.nodes.size());
  return made;
}

// T of every edge is the width of the corridor less the body's. The search falls 10 mm short of it,
// where what was driven would by 160 mm.
TEST(EdgePaths, ACorridorHasItsWidthAtEveryEdge) {
  const Driven made = corridor();
  const SearchSpace space(made.cells);
  const Robot robot = robot_of(0.45, 0.35);
  const EdgePaths found = paths_of(made, space, robot);
  ASSERT_EQ(found.paths.size(), made.edges.size());
  for (const auto& path : found.paths) {
    ASSERT_TRUE(path);
    EXPECT_LE(path->checked.margin_m, 0.55 + 1e-9);
    EXPECT_GT(path->checked.margin_m, 0.55 - 0.010);
  }
  for (std::size_t n = 0; n < made.nodes.size(); ++n) {
    EXPECT_LT(std::abs(found.waypoints[n].yaw_rad), 0.1);
    EXPECT_TRUE(is_near(found.waypoints[n].position, made.nodes[n], made.start, made.goal, 0.15));
  }
}

/// Round a square of corridors 0.8 m wide, a node every 0.24 m, arcs of radius 0.58 m at corners.
Driven ring() {
  Driven made{cells_where({-2, -2},
                          {2, 2},
                          [](Point p) {
                            const double far = std::max(std::abs(p.x_m), std::abs(p.y_m));
                            return far > 0.9 && far < 1.7;
                          }),
              {},
              {},
              Disc{{-0.3, -1.3}, 0.2},
              Disc{{1.3, 0.5}, 0.2}};
  Point at{-0.72, -1.3};
  double yaw = 0.0;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 6; ++i) {
      made.nodes.push_back(node_at(at, yaw));
      at = at + 0.24 * direction(yaw);
    }
    const Point middle = at + 0.58 * direction(yaw + 0.5 * kPi);
    for (int i = 0; i < 3; ++i) {
      const double angle = yaw - 0.5 * kPi + i * kPi / 6.0;
      made.nodes.push_back(node_at(middle + 0.58 * direction(angle), yaw + i * kPi / 6.0));
    }
    yaw += 0.5 * kPi;
    at = middle + 0.58 * direction(yaw - 0.5 * kPi);
  }
  made.edges = in_a_row(made.nodes.size());
  const auto last = static_cast<std::uint32_t>(made.nodes.size() - 1);
  made.edges.push_back(edge_between({last, Side::front}, {0, Side::back}));
  return made;
}

// What the paths of edges that follow each other prove together is what each proves.
TEST(EdgePaths, ChainsProveTheLeastOfTheirEdges) {
  const Driven made = ring();
  const SearchSpace space(made.cells);
  const Robot robot = robot_of(0.3, 0.2);
  const EdgePaths found = paths_of(made, space, robot);
  const std::size_t count = made.edges.size();
  for (std::size_t e = 0; e < count; ++e) {
    ASSERT_TRUE(found.paths[e]) << e;
    EXPECT_GT(found.paths[e]->checked.margin_m, 0.2) << e;
    EXPECT_LE(found.paths[e]->checked.margin_m, 0.5 + 1e-9) << e;
  }
  for (std::size_t first = 0; first < count; first += 3) {
    for (const std::size_t length : {2U, 5U, 17U}) {
      std::vector<EdgeStep> steps;
      double least_m = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < length; ++i) {
        const auto e = static_cast<std::uint32_t>((first + i) % count);
        steps.push_back({e, false});
        least_m = std::min(least_m, found.paths[e]->checked.margin_m);
      }
      for (const bool back : {false, true}) {
        if (back) {
          std::reverse(steps.begin(), steps.end());
          std::ranges::for_each(steps, [](EdgeStep& step) { step.is_reversed = true; });
        }
        const Path path = chained(found, steps);
        const Checked checked = space.checker.check(
            path, Disc{path.front().from, 0.0}, Disc{path.back().to, 0.0}, robot);
        ASSERT_EQ(checked.refused, "");
        EXPECT_NEAR(checked.margin_m, least_m, 1e-9);
      }
    }
  }
}

TEST(EdgePaths, TheWidestChainLeadsFromSToG) {
  const Driven made = ring();
  const SearchSpace space(made.cells);
  const Robot robot = robot_of(0.3, 0.2);
  const EdgePaths found = paths_of(made, space, robot);
  const std::vector<EdgeStep> steps = widest_chain(found, made.edges, made.start, made.goal);
  ASSERT_FALSE(steps.empty());
  const Checked checked = space.checker.check(chained(found, steps), made.start, made.goal, robot);
  EXPECT_EQ(checked.refused, "");
  EXPECT_GT(checked.margin_m, 0.2);
  EdgePaths broken = found;  // the ring leads round the other way, and then not at all
  broken.paths[steps[2].edge] = std::nullopt;
  const auto other = widest_chain(broken, made.edges, made.start, made.goal);
  ASSERT_FALSE(other.empty());
  EXPECT_GT(other.size(), steps.size());
  EXPECT_EQ(space.checker.check(chained(found, other), made.start, made.goal, robot).refused, "");
  broken.paths[other[2].edge] = std::nullopt;
  EXPECT_TRUE(widest_chain(broken, made.edges, made.start, made.goal).empty());
}

TEST(EdgePaths, AnEdgeIsRefusedUnlessItLeadsAlongItsWaypoints) {
  const Driven made = corridor();
  const SearchSpace space(made.cells);
  const Robot robot = robot_of(0.45, 0.35);
  const EdgePaths found = paths_of(made, space, robot);
  const Path& path = found.paths[3]->path;
  const auto refused = [&](const std::vector<Pose>& waypoints, const Edge& edge) {
    return check_edge(space.checker, path, edge, waypoints, robot).refused;
  };
  const std::string no = "the path does not lead from waypoint to waypoint";
  EXPECT_EQ(refused(found.waypoints, made.edges[3]), "");
  EXPECT_EQ(refused(found.waypoints, made.edges[4]), no);
  EXPECT_EQ(refused(found.waypoints, edge_between({3, Side::back}, {4, Side::back})), no);
  for (const std::size_t n : {3U, 4U}) {
    for (const double by : {1e-6, -1e-6}) {
      std::vector<Pose> waypoints = found.waypoints;
      waypoints[n].yaw_rad += by;
      EXPECT_EQ(refused(waypoints, made.edges[3]), no);
      waypoints = found.waypoints;
      waypoints[n].position.y_m += by;
      EXPECT_EQ(refused(waypoints, made.edges[3]), no);
    }
  }
}

}  // namespace
}  // namespace tcert::witness
