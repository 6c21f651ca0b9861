#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <tcert/certifier.hpp>
#include <tcert/route_planner.hpp>

#include "support/allocations.hpp"
#include "support/random_run.hpp"
#include "support/shortest_oracle.hpp"

namespace tcert {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

// Nodes 0 at (0, 0), 1 at (1, 0), 2 at (0, 1); the goal is at (3, 0). Unexplored space costs
// 1 + 0.05 / 0.05 = 2 a metre.
struct Crossroads {
  Crossroads() {
    for (const Point at : {Point{0.0, 0.0}, Point{1.0, 0.0}, Point{0.0, 1.0}}) {
      graph.add_node({{at, 0.0}, {1.0, 0.0}, false, false});
    }
    pass(0, 1, 0.15);
    pass(0, 2, 0.15);
    planner.follow(graph, 0, 0);
    planner.follow(graph, 1, 0);
  }
  void pass(std::uint32_t from, std::uint32_t to, double margin_m) {
    Pass one;
    one.margin_m = margin_m;
    graph.record_pass({from, Side::front}, {to, Side::back}, one);
  }

  CorridorGraph graph{8, 8, 1.0};
  RoutePlanner planner{8, 8, Disc{{3.0, 0.0}, 0.3}, {0.05, 0.005}, {0.05, 0.05, 20.0}};
};

TEST(RoutePlanner, GoesOnThroughTheUnexplored) {
  Crossroads c;
  const Route route = c.planner.replan();
  EXPECT_EQ(route.exit, 1U);
  EXPECT_EQ(route.next, kNone);
  EXPECT_EQ(route.cost, 4'000'000);
}

TEST(RoutePlanner, ABlockSendsItBackUntilItIsLifted) {
  Crossroads c;
  c.planner.block_ahead(false);
  // Back to 0 at 1 + 0.05 / (0.15 - 0.05) = 1.5 a metre, then 3 m at 2.
  Route route = c.planner.replan();
  EXPECT_EQ(route.exit, 0U);
  EXPECT_EQ(route.next, 0U);
  EXPECT_EQ(route.cost, 7'500'000);
  c.planner.follow(c.graph, 1, 20 * kSecond - 1);
  EXPECT_EQ(c.planner.replan().exit, 0U);
  c.planner.follow(c.graph, 1, 20 * kSecond);
  EXPECT_EQ(c.planner.replan().exit, 1U);
}

TEST(RoutePlanner, ANarrowEdgeIsClosedUntilItsMarginRises) {
  Crossroads c;
  c.pass(1, 2, 0.055);  // robust 0.005: not more than epsilon
  c.planner.follow(c.graph, 2, kSecond);
  c.planner.block_ahead(false);
  // By 0 to 1 at 1.5 a metre, then 2 m at 2.
  const Route round = c.planner.replan();
  EXPECT_EQ(round.next, 0U);
  EXPECT_EQ(round.cost, 7'000'000);
  c.pass(1, 2, 0.25);
  c.planner.follow(c.graph, 1, kSecond);
  c.planner.follow(c.graph, 2, kSecond);
  // 2 - 1 now costs sqrt(2) * 1.25, less than 3.
  const Route route = c.planner.replan();
  EXPECT_EQ(route.next, 1U);
  EXPECT_EQ(route.cost, static_cast<PathCost>(std::ceil(1e6 * std::sqrt(2.0) * 1.25)) + 4'000'000);
}

TEST(RoutePlanner, TooMuchForceBlocksTheEdgeThatWasWalked) {
  Crossroads c;
  c.planner.block_ahead(true);  // on the way from 1 to 2
  c.pass(1, 2, 0.25);
  c.planner.follow(c.graph, 2, kSecond);
  // From 2 the edge to 1 and the frontier of 1 are both blocked.
  const Route route = c.planner.replan();
  EXPECT_NE(route.exit, 1U);
  c.planner.follow(c.graph, 2, 21 * kSecond);
  c.planner.block_ahead(false);
  EXPECT_EQ(c.planner.replan().exit, 1U);
}

TEST(RoutePlanner, RefusesImpossibleParameters) {
  EXPECT_THROW(validate(RouteParameters{-0.1, 0.02, 20.0}), std::invalid_argument);
  EXPECT_THROW(validate(RouteParameters{0.05, 0.0, 20.0}), std::invalid_argument);
  EXPECT_THROW(validate(RouteParameters{0.05, 0.02, 0.0}), std::invalid_argument);
}

// Replans as often as it can on random runs: the cost is that of a search from scratch.
TEST(RoutePlanner, EqualsASearchFromScratchOnRandomRuns) {
  std::size_t plans = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const test_support::Run run = test_support::random_run(seed, 800);
    const CertificateParameters parameters;
    Certifier certifier(run.robot, run.course, parameters);
    RoutePlanner planner(parameters.max_nodes,
                         parameters.max_edges,
                         run.course.goal.value_or(Disc{{2.0, 0.0}, 0.3}),
                         {0.0, 0.005},
                         {});
    for (std::size_t i = 0; i < run.ticks.size(); ++i) {
      certifier.update(run.ticks[i]);
      const std::size_t allocations = test_support::allocation_count();
      planner.follow(certifier.graph(), certifier.last_node(), run.ticks[i].time_ns);
      if (i % 7 == 0) {
        planner.block_ahead(i % 2 == 0);
        const Route route = planner.replan();
        ASSERT_EQ(test_support::allocation_count(), allocations);
        DStarLite fresh = planner.search();
        fresh.forget();
        ASSERT_TRUE(certifier.last_node() == kNone || fresh.plan() == route.cost);
        ++plans;
      }
    }
  }
  EXPECT_GT(plans, 1000U);
}

}  // namespace
}  // namespace tcert
