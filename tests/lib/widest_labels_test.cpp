#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <tcert/widest_labels.hpp>

#include "support/allocations.hpp"
#include "support/widest_oracle.hpp"

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Both kinds of labels kept on one random multigraph, with what each state starts with.
struct Labelled {
  CorridorGraph graph{12, 40, 1.0};
  WidestLabels sided{WidestLabels::Kind::sided, WidestLabels::Margin::certified, 12};
  WidestLabels sideless{WidestLabels::Kind::sideless, WidestLabels::Margin::felt, 12};
  std::vector<double> sided_source;
  std::vector<double> sideless_source;

  void add_node(bool is_source, bool is_sink, double seed_value) {
    const std::uint32_t node = graph.add_node({{}, {}, is_source, is_sink});
    const double value = is_source ? kInfinity : seed_value;
    sided.add_node(node, is_sink);
    sideless.add_node(node, is_sink);
    sided_source.insert(sided_source.end(), 2, is_source ? kInfinity : -kInfinity);
    sideless_source.push_back(value);
    if (is_source) {
      sided.raise_node(graph, node, kInfinity);
    }
    sideless.raise_node(graph, node, value);
  }

  void record(EdgeEnd a, EdgeEnd b, double margin_m) {
    Pass pass;
    pass.margin_m = margin_m;
    const auto recorded = graph.record_pass(a, b, pass);
    if (recorded.changed) {
      sided.relax_edge(graph, recorded.edge);
      sideless.relax_edge(graph, recorded.edge);
    }
  }

  void expect_exact() const {
    const auto by_side =
        test_support::widest_by_search(graph, WidestLabels::Kind::sided, sided_source);
    const auto by_node =
        test_support::widest_by_search(graph, WidestLabels::Kind::sideless, sideless_source);
    for (std::uint32_t n = 0; n < graph.nodes().size(); ++n) {
      ASSERT_EQ(sided.leaving(n, Side::back), by_side[2 * n]);
      ASSERT_EQ(sided.leaving(n, Side::front), by_side[2 * n + 1]);
      ASSERT_EQ(sideless.at(n), by_node[n]);
    }
    ASSERT_EQ(sided.sink(), test_support::certificate_by_search(graph, true));
  }
};

TEST(WidestLabels, EqualASearchFromScratchAfterEveryUpdate) {
  std::size_t updates = 0;
  for (std::uint32_t seed = 0; seed < 10'000; ++seed) {
    std::mt19937 engine(seed);
    const auto bits = [&engine] { return static_cast<std::uint32_t>(engine()); };
    Labelled labelled;
    labelled.add_node(true, false, 0.0);
    labelled.add_node(false, true, -kInfinity);
    for (int update = 0; update < 40; ++update) {
      const auto nodes = static_cast<std::uint32_t>(labelled.graph.nodes().size());
      if (bits() % 4 == 0 && !labelled.graph.nodes_full()) {
        const double seed_value =
            bits() % 3 == 0 ? static_cast<double>(bits() % 7) - 3.0 : -kInfinity;
        labelled.add_node(bits() % 8 == 0, bits() % 8 == 0, seed_value);
      } else {
        const std::uint32_t a = bits() % nodes;
        const std::uint32_t b = (a + 1 + bits() % (nodes - 1)) % nodes;
        labelled.record({a, static_cast<Side>(bits() % 2)},
                        {b, static_cast<Side>(bits() % 2)},
                        (static_cast<double>(bits() % 7) - 3.0) / 7.0);
      }
      ++updates;
      labelled.expect_exact();
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "seed " << seed << " update " << update;
    }
  }
  EXPECT_EQ(updates, 400'000U);
}

TEST(WidestLabels, APathCannotTurnRoundAtANode) {
  // source 0 --(front..back)-- 1, and 2 attached to the side of 1 that the path enters by.
  Labelled labelled;
  labelled.add_node(true, false, 0.0);
  labelled.add_node(false, false, -kInfinity);
  labelled.add_node(false, true, -kInfinity);
  labelled.record({0, Side::front}, {1, Side::back}, 0.5);
  labelled.record({1, Side::back}, {2, Side::back}, 0.4);
  EXPECT_EQ(labelled.sided.sink(), -kInfinity);
  EXPECT_EQ(labelled.sideless.at(2), 0.4);
  labelled.record({1, Side::front}, {2, Side::back}, 0.3);
  EXPECT_EQ(labelled.sided.sink(), 0.3);
}

TEST(WidestLabels, UpdatesAllocateNothing) {
  Labelled labelled;
  labelled.add_node(true, false, 0.0);
  labelled.add_node(false, true, -kInfinity);
  const std::size_t before = test_support::allocation_count();
  for (int k = 0; k < 100; ++k) {
    labelled.record({0, Side::front}, {1, Side::back}, 0.01 * k);
  }
  EXPECT_EQ(test_support::allocation_count(), before);
  EXPECT_EQ(labelled.sided.sink(), 0.99);
}

}  // namespace
}  // namespace tcert
