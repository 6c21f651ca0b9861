#include <gtest/gtest.h>

#include <algorithm>
#include <federation/federate.hpp>
#include <federation/submap_text.hpp>
#include <random>
#include <stdexcept>
#include <tcert/widest_labels.hpp>

#include "support/widest_oracle.hpp"

namespace tcert::federation {
namespace {

const Agent kAgent{0.45, 0.35, 0.0, 0.0};
using Random = std::mt19937_64;

std::uint32_t below(Random& random, std::size_t end) {
  return static_cast<std::uint32_t>(random() % end);
}

/// A corridor graph of places 10 m apart, so that nothing but one and the same place is near.
Source random_source(Random& random, const std::string& name) {
  Source source{name, MarginKind::witness, 0.0, 0.0, {}, {}};
  const std::size_t nodes = 2 + below(random, 10);
  for (std::size_t n = 0; n < nodes; ++n) {
    source.nodes.push_back({{{10.0 * static_cast<double>(n), 0.5}, 0.1 * static_cast<double>(n)},
                            n == 0 || below(random, 8) == 0,
                            n + 1 == nodes || below(random, 8) == 0,
                            0.05 * below(random, 12)});
  }
  const std::size_t edges = nodes + below(random, 10);
  for (std::size_t e = 0; e < edges; ++e) {
    const std::uint32_t n = below(random, nodes);
    const std::uint32_t to =
        below(random, 3) == 0
            ? below(random, nodes)
            : std::min<std::uint32_t>(n + 1, static_cast<std::uint32_t>(nodes) - 1);
    const Side leaves = below(random, 4) == 0 ? Side::back : Side::front;
    source.edges.push_back({{EdgeEnd{n, leaves}, EdgeEnd{to, opposite(leaves)}},
                            0.05 * (1 + below(random, 12)),
                            0.01 * below(random, 4)});
  }
  return source;
}

Submap submap_of(std::vector<Source> sources) { return in_order({kAgent, "", std::move(sources)}); }

/// Some of a submap's edges, with the nodes of all.
Submap part_of(const Submap& whole, const std::vector<std::uint8_t>& holds) {
  Submap part{whole.agent, "", {}};
  std::size_t i = 0;
  for (const Source& source : whole.sources) {
    Source some = source;
    some.edges.clear();
    for (const SubmapEdge& edge : source.edges) {
      if (holds[i++] != 0) {
        some.edges.push_back(edge);
      }
    }
    part.sources.push_back(std::move(some));
  }
  return in_order(std::move(part));
}

TEST(Merge, IsTheSameBytesForAnySplitAndOrder) {
  Random random(1);
  for (int run = 0; run < 10'000; ++run) {
    std::vector<Source> sources;
    for (std::size_t s = 0, n = 1 + below(random, 3); s < n; ++s) {
      sources.push_back(random_source(random, std::string(1, static_cast<char>('a' + s))));
    }
    const Submap whole = submap_of(sources);
    std::size_t edges = 0;
    for (const Source& source : whole.sources) {
      edges += source.edges.size();
    }
    // Every edge goes to one piece, and some to others too.
    const std::size_t pieces = 2 + below(random, 6);
    std::vector<std::vector<std::uint8_t>> holds(pieces, std::vector<std::uint8_t>(edges));
    for (std::size_t e = 0; e < edges; ++e) {
      holds[below(random, pieces)][e] = 1;
      holds[below(random, pieces)][e] = 1;
    }
    std::vector<Submap> heap;
    for (const auto& some : holds) {
      heap.push_back(part_of(whole, some));
    }
    const Submap twice = heap.front();
    heap.push_back(twice);  // said twice
    while (heap.size() > 1) {
      std::ranges::shuffle(heap, random);
      Submap both = merge(heap[heap.size() - 1], heap[heap.size() - 2]);
      heap.resize(heap.size() - 2);
      heap.push_back(std::move(both));
    }
    ASSERT_EQ(to_text(heap.front()), to_text(whole));
    ASSERT_EQ(to_text(merge(whole, whole)), to_text(whole));
    ASSERT_EQ(federate(heap.front()).way.margin_m, federate(whole).way.margin_m);
  }
}

TEST(Federate, GivesACutGraphTheUncutValueBitForBit) {
  Random random(2);
  int connected = 0;
  for (int run = 0; run < 10'000; ++run) {
    const Source whole = submap_of({random_source(random, "whole")}).sources.front();
    const double uncut = widest_way(whole.nodes, whole.edges, false).margin_m;
    const std::size_t robots = 1 + below(random, 8);
    std::vector<Source> cut(robots, {"", MarginKind::witness, 0.0, 0.0, whole.nodes, {}});
    for (std::size_t r = 0; r < robots; ++r) {
      cut[r].name = "robot" + std::to_string(r);
    }
    for (const SubmapEdge& edge : whole.edges) {
      cut[below(random, robots)].edges.push_back(edge);
    }
    const Federation found = federate(submap_of(cut));
    ASSERT_EQ(found.way.margin_m, uncut);
    for (const double own : found.own) {
      ASSERT_LE(own, uncut);
    }
    connected += uncut > 0.0 ? 1 : 0;
  }
  EXPECT_GT(connected, 3'000);
}

TEST(WidestWay, EqualsTheOracleAndItsStepsAreAWay) {
  Random random(3);
  for (int run = 0; run < 3'000; ++run) {
    const Source source = submap_of({random_source(random, "r")}).sources.front();
    CorridorGraph graph(static_cast<std::uint32_t>(source.nodes.size()),
                        static_cast<std::uint32_t>(source.edges.size()),
                        1.0);
    for (const SubmapNode& node : source.nodes) {
      graph.add_node({node.pose, {}, node.in_start, node.in_goal});
    }
    for (const SubmapEdge& edge : source.edges) {
      Pass pass;
      pass.margin_m = edge.margin_m;
      graph.record_pass(edge.ends[0], edge.ends[1], pass);
    }
    const Way way = widest_way(source.nodes, source.edges, false);
    ASSERT_EQ(way.margin_m, test_support::certificate_by_search(graph, true));
    if (way.steps.empty()) {
      continue;
    }
    double least_m = std::numeric_limits<double>::infinity();
    EdgeEnd entered{};
    for (const WayStep& step : way.steps) {
      const SubmapEdge& edge = source.edges[step.edge];
      const EdgeEnd& from = edge.ends[step.is_reversed ? 1 : 0];
      if (&step == &way.steps.front()) {
        ASSERT_TRUE(source.nodes[from.node].in_start);
      } else {
        ASSERT_EQ(from, (EdgeEnd{entered.node, opposite(entered.side)}));
      }
      entered = edge.ends[step.is_reversed ? 0 : 1];
      least_m = std::min(least_m, edge.margin_m);
    }
    ASSERT_TRUE(source.nodes[entered.node].in_goal);
    ASSERT_EQ(least_m, way.margin_m);
  }
}

/// Two lanes of one corridor, one behind the other, along x from 0 and from `from_m`.
Submap relay(double from_m, double aside_m, double frame_error_m) {
  const auto lane = [](const std::string& name, double x, double y, bool begins) {
    Source source{name, MarginKind::witness, 0.0, 0.0, {}, {}};
    for (int n = 0; n <= 4; ++n) {
      source.nodes.push_back(
          {{{x + 0.25 * n, y}, 0.0}, begins && n == 0, !begins && n == 4, SubmapNode{}.margin_m});
    }
    for (std::uint32_t n = 0; n < 4; ++n) {
      source.edges.push_back(
          {{EdgeEnd{n, Side::front}, EdgeEnd{n + 1, Side::back}}, 0.6, SubmapEdge{}.spread_m});
    }
    return source;
  };
  std::vector<Source> sources{lane("a", 0.0, 0.0, true), lane("b", from_m, aside_m, false)};
  sources[1].frame_error_m = frame_error_m;
  return submap_of(sources);
}

TEST(Federate, JoinsTwoHalvesOfACorridor) {
  const Federation found = federate(relay(1.2, 0.0, 0.0));
  EXPECT_TRUE(std::isinf(found.own[0]) && std::isinf(found.own[1]));
  // The nearest pair ahead of each other: a's last at 1.0 m and b's first at 1.2 m.
  EXPECT_NEAR(found.way.margin_m, 0.6 - 0.2, 1e-12);
  EXPECT_EQ(federate(relay(1.0, 0.0, 0.0)).way.margin_m, 0.6);  // one place
  EXPECT_LT(federate(relay(1.2, 0.0, 0.05)).way.margin_m, 0.35);
  EXPECT_GT(federate(relay(1.2, 0.0, 0.05)).way.margin_m, 0.0);
}

TEST(Federate, JoinsBesideAnEdgeWhosePathIsKnown) {
  // The lanes overlap by 0.1 m and lie 0.01 m aside; by length alone 0.15 m would be lost.
  Submap submap = relay(0.9, 0.01, 0.0);
  EXPECT_LT(federate(submap).way.margin_m, 0.46);
  for (Source& source : submap.sources) {
    for (SubmapEdge& edge : source.edges) {
      edge.spread_m = 0.002;
    }
  }
  const double margin_m = federate(submap).way.margin_m;
  // From a's 0.75 m to b's 1.15 m: half of that beside each; 0.005 off both, a bow of 0.005.
  EXPECT_NEAR(margin_m, 0.6 - 2.0 * (0.005 + 0.005 + 0.002), 0.003);
}

TEST(Federate, TakesWhatIsKnownOfANodeItself) {
  Submap submap = relay(1.2, 0.0, 0.0);
  for (Source& source : submap.sources) {
    for (SubmapNode& node : source.nodes) {
      node.margin_m = 0.75;  // a wide place: the edges' 0.6 are those of a gate nearby
    }
  }
  EXPECT_NEAR(federate(submap).way.margin_m, 0.75 - 0.2, 1e-12);
}

TEST(Federate, JoinsNothingWhoseFrameIsNotKnown) {
  const Federation found = federate(relay(1.2, 0.0, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(found.known.joins, 0U);
  EXPECT_TRUE(std::isinf(found.way.margin_m));
}

TEST(Federate, DoesNotTurnRoundAtAJoin) {
  // The second robot came the other way: its front faces the first one's. What counts is the line.
  Submap submap = relay(1.2, 0.0, 0.0);
  for (SubmapNode& node : submap.sources[1].nodes) {
    node.pose.yaw_rad = 3.141592653589793;
  }
  for (SubmapEdge& edge : submap.sources[1].edges) {
    for (EdgeEnd& end : edge.ends) {
      end.side = opposite(end.side);
    }
  }
  EXPECT_NEAR(federate(submap).way.margin_m, 0.4, 1e-9);
  // Turned with its lane, it leads back to where it came from: from the end of a there is no way.
  for (SubmapEdge& edge : submap.sources[1].edges) {
    for (EdgeEnd& end : edge.ends) {
      end.side = opposite(end.side);
    }
  }
  EXPECT_TRUE(std::isinf(federate(submap).way.margin_m));
}

TEST(Federate, RefusesMoreEdgesAtTwoNodesThanItCanLookAt) {
  constexpr std::uint32_t kSpokes = 15'000;
  const auto hub = [](const std::string& name, double y) {
    Source source{name, MarginKind::witness, 0.0, 0.0, {{{{0.0, y}, 0.0}}}, {}};
    for (std::uint32_t n = 1; n <= kSpokes; ++n) {
      source.nodes.push_back({{{1.0 + 1e-5 * n, y}, 0.0}});
      source.edges.push_back({{EdgeEnd{0, Side::front}, EdgeEnd{n, Side::back}}, 0.3, 0.0});
    }
    return source;
  };
  Submap submap{kAgent, "", {hub("a", 0.0), hub("b", 0.0)}};
  submap.sources[1].nodes[0].pose.position.x_m = 1e-3;
  EXPECT_THROW((void)federate(submap), std::length_error);
}

TEST(Merge, RefusesOtherAgents) {
  const Submap a = relay(1.2, 0.0, 0.0);
  Submap b = a;
  b.agent.body_width_m = 0.5;
  EXPECT_THROW((void)merge(a, b), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::federation
