#include <gtest/gtest.h>

#include <array>
#include <set>
#include <tcert/corridor_graph.hpp>

namespace tcert {
namespace {

Node node_at(double x_m, double y_m) { return {{{x_m, y_m}, 0.0}, {1.0, 0.0}, false, false}; }

// A look-up finds all nodes in its box, and looks at few others whichever way the nodes lie: that
// is what bounds the work of a tick.
TEST(CorridorGraph, LooksAtFewNodesWhereverTheyLie) {
  for (const auto& [step_x, step_y] :
       {std::array{1.0, 0.0}, std::array{0.0, 1.0}, std::array{-1.0, 1.0}}) {
    CorridorGraph graph(2000, 10, 0.5);
    for (int k = 0; k < 2000; ++k) {
      ASSERT_EQ(graph.add_node(node_at(step_x * k, step_y * k)), static_cast<std::uint32_t>(k));
    }
    EXPECT_TRUE(graph.nodes_full());
    EXPECT_EQ(graph.add_node(node_at(0.0, 0.0)), kNone);
    std::size_t looked_at = 0;
    std::set<std::uint32_t> found;
    for (int k = 0; k < 2000; k += 100) {
      const Point middle{step_x * k, step_y * k};
      graph.for_each_node_near(
          middle - Point{0.6, 0.6}, middle + Point{0.6, 0.6}, [&](std::uint32_t node) {
            ++looked_at;
            found.insert(node);
          });
      EXPECT_EQ(found.count(static_cast<std::uint32_t>(k)), 1U);
    }
    EXPECT_LT(looked_at, 20U * 60U) << "of 2,000 nodes a look-up, of whose cells there are 16";
  }
}

TEST(CorridorGraph, KeepsTheBestPassOfAnEdgeWhicheverWayItWasDriven) {
  CorridorGraph graph(3, 2, 0.5);
  for (int k = 0; k < 3; ++k) {
    graph.add_node(node_at(k, 0.0));
  }
  const EdgeEnd a{0, Side::front};
  const EdgeEnd b{1, Side::back};
  Pass pass;
  pass.margin_m = 0.2;
  pass.width_m = 0.6;
  const auto first = graph.record_pass(a, b, pass);
  EXPECT_EQ(first.edge, 0U);
  EXPECT_TRUE(first.changed);
  pass.margin_m = 0.1;
  pass.width_m = 0.5;
  EXPECT_FALSE(graph.record_pass(b, a, pass).changed) << "a worse one";
  EXPECT_EQ(graph.edges()[0].pass.width_m, 0.6);
  pass.margin_m = 0.3;
  pass.width_m = 0.7;
  const auto better = graph.record_pass(b, a, pass);
  EXPECT_EQ(better.edge, 0U);
  EXPECT_TRUE(better.changed);
  EXPECT_EQ(graph.edges()[0].pass.width_m, 0.7);
  EXPECT_EQ(graph.edges()[0].certified.margin_m, 0.3);
  // What is certified alone may rise, and never falls.
  EXPECT_TRUE(graph.certify(0, {0.35, {}, 0.0, 0.0}));
  EXPECT_FALSE(graph.certify(0, {0.35, {}, 0.0, 0.0}));
  EXPECT_FALSE(graph.certify(0, {0.1, {}, 0.0, 0.0}));
  EXPECT_EQ(graph.edges()[0].certified.margin_m, 0.35);
  // By another side it is another edge; then there is no room, and the known one still rises.
  EXPECT_EQ(graph.find_edge(a, {1, Side::front}), kNone);
  EXPECT_EQ(graph.record_pass(a, {1, Side::front}, pass).edge, 1U);
  EXPECT_TRUE(graph.edges_full());
  EXPECT_EQ(graph.record_pass(a, {2, Side::back}, pass).edge, kNone);
  pass.margin_m = 0.4;
  EXPECT_EQ(graph.record_pass(a, b, pass).edge, 0U);
  std::size_t at_b = 0;
  graph.for_each_edge_at(1, [&](std::uint32_t edge, std::uint32_t end) {
    EXPECT_EQ(graph.edges()[edge].ends[end].node, 1U);
    ++at_b;
  });
  EXPECT_EQ(at_b, 2U);
  graph.clear();
  EXPECT_EQ(graph.nodes().size(), 0U);
  EXPECT_EQ(graph.add_node(node_at(0.0, 0.0)), 0U);
  EXPECT_EQ(graph.find_edge(a, b), kNone);
}

}  // namespace
}  // namespace tcert
