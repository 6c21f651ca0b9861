#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <tcert/dstar_lite.hpp>

#include "support/allocations.hpp"
#include "support/shortest_oracle.hpp"

namespace tcert {
namespace {

using test_support::CostedEdge;
using test_support::costs_by_dijkstra;

constexpr PathCost kMetre = 1'000'000;

TEST(DStarLite, TakesTheOtherWayWhenTheShortOneIsBlocked) {
  // 0 - 1 - 3 costs 2 m, 0 - 2 - 3 costs 3 m.
  DStarLite search(4, 4);
  search.add_state({0.0, 0.0});
  search.add_state({0.5, 0.5});
  search.add_state({0.5, -0.5});
  search.add_state({1.0, 0.0});
  search.add_edge(0, 1, kMetre);
  const std::uint32_t short_end = search.add_edge(1, 3, kMetre);
  search.add_edge(0, 2, kMetre);
  search.add_edge(2, 3, 2 * kMetre);
  search.set_start(0);
  search.set_goal(3);
  EXPECT_EQ(search.plan(), 2 * kMetre);
  EXPECT_EQ(search.next(0).state, 1U);
  EXPECT_EQ(search.next(1).state, 3U);
  EXPECT_EQ(search.next(3).state, DStarLite::kNoState);

  search.set_cost(short_end, kBlocked);
  EXPECT_EQ(search.plan(), 3 * kMetre);
  EXPECT_EQ(search.next(0).state, 2U);

  // From 1 the way back costs one metre more.
  search.set_start(1);
  EXPECT_EQ(search.plan(), 4 * kMetre);
  search.set_cost(short_end, kMetre);
  EXPECT_EQ(search.plan(), kMetre);
}

TEST(DStarLite, SaysThatThereIsNoWay) {
  DStarLite search(2, 1);
  search.add_state({0.0, 0.0});
  search.add_state({1.0, 0.0});
  search.set_start(0);
  search.set_goal(1);
  EXPECT_EQ(search.plan(), kBlocked);
  EXPECT_EQ(search.add_edge(0, 1, 0), 0U);
  EXPECT_EQ(search.add_edge(0, 1, 0), DStarLite::kNoState) << "there is room for one";
  EXPECT_EQ(search.plan(), kMetre + 1) << "never less than the distance";
}

// A random multigraph, what its search says, and what Dijkstra says.
class RandomGraph {
 public:
  explicit RandomGraph(std::uint32_t seed)
      : random_(seed), states_(2 + below(18)), search_(40, 120) {
    for (std::uint32_t s = 0; s < states_; ++s) {
      add_state();
    }
    const std::uint32_t edges = below(3 * states_) + 1;
    for (std::uint32_t e = 0; e < edges; ++e) {
      add_edge();
    }
    start_ = below(states_);
    goal_ = below(states_);
    search_.set_start(start_);
    search_.set_goal(goal_);
  }

  void change() {
    const std::uint32_t changes = 1 + below(4);
    for (std::uint32_t c = 0; c < changes; ++c) {
      const std::uint32_t what = below(10);
      if (what < 6) {
        const std::uint32_t edge = below(static_cast<std::uint32_t>(edges_.size()));
        search_.set_cost(edge, random_cost());
        edges_[edge].cost = search_.cost(edge);
      } else if (what < 8) {
        start_ = what == 6 ? below(states_) : step();
        search_.set_start(start_);
      } else if (what == 8 && edges_.size() < 110) {
        add_edge();
      } else if (states_ < 40) {
        ++states_;
        add_state();
      }
    }
  }

  // Repaired, from scratch, and by Dijkstra: one cost; and the steps add up to it.
  void expect_shortest() {
    const std::size_t allocations = test_support::allocation_count();
    const std::uint64_t before = search_.expansions();
    const PathCost repaired = search_.plan();
    repaired_ += search_.expansions() - before;
    ASSERT_EQ(test_support::allocation_count(), allocations);
    const auto expected = costs_by_dijkstra(states_, edges_, goal_);
    ASSERT_EQ(repaired, expected[start_]);
    PathCost along = 0;
    std::uint32_t at = start_;
    for (std::uint32_t steps = 0; repaired != kBlocked && at != goal_; ++steps) {
      ASSERT_LT(steps, states_);
      const DStarLite::Step step = search_.next(at);
      along += search_.cost(step.edge);
      at = step.state;
    }
    ASSERT_TRUE(repaired == kBlocked || along == repaired);
    expect_exact_on_every_shortest_path(expected);
    DStarLite fresh = search_;
    fresh.forget();
    const std::uint64_t start = fresh.expansions();
    ASSERT_EQ(fresh.plan(), repaired);
    scratch_ += fresh.expansions() - start;
  }

  [[nodiscard]] std::uint64_t repaired() const { return repaired_; }
  [[nodiscard]] std::uint64_t scratch() const { return scratch_; }

 private:
  // The states that some shortest path leads through are as far from the start as is left.
  void expect_exact_on_every_shortest_path(const std::vector<PathCost>& to_goal) {
    if (to_goal[start_] == kBlocked) {
      return;
    }
    const auto from_start = costs_by_dijkstra(states_, edges_, start_);
    for (std::uint32_t state = 0; state < states_; ++state) {
      if (state != start_ && from_start[state] != kBlocked && to_goal[state] != kBlocked &&
          from_start[state] + to_goal[state] == to_goal[start_]) {
        ASSERT_EQ(search_.cost_to_goal(state), to_goal[state]) << "state " << state;
      }
    }
  }

  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }

  // Few distinct values, so that paths tie; some blocked, some below the distance.
  PathCost random_cost() {
    return below(5) == 0 ? kBlocked : static_cast<PathCost>(below(5)) * kMetre;
  }
  void add_state() {
    search_.add_state({0.5 * static_cast<double>(below(5)), 0.5 * static_cast<double>(below(5))});
  }
  void add_edge() {
    const std::uint32_t a = below(states_);
    const std::uint32_t b = below(states_);
    const std::uint32_t edge = search_.add_edge(a, b, random_cost());
    edges_.push_back({{a, b}, search_.cost(edge)});
  }
  std::uint32_t step() {
    const DStarLite::Step step = search_.next(start_);
    return step.state == DStarLite::kNoState ? start_ : step.state;
  }

  std::mt19937 random_;
  std::uint32_t states_;
  DStarLite search_;
  std::vector<CostedEdge> edges_;
  std::uint32_t start_ = 0;
  std::uint32_t goal_ = 0;
  std::uint64_t repaired_ = 0;
  std::uint64_t scratch_ = 0;
};

TEST(DStarLite, EqualsDijkstraAfterEveryChange) {
  constexpr std::uint32_t kGraphs = 10'000;
  constexpr int kChanges = 12;
  std::uint64_t repaired = 0;
  std::uint64_t scratch = 0;
  for (std::uint32_t seed = 0; seed < kGraphs; ++seed) {
    SCOPED_TRACE(seed);
    RandomGraph graph(seed);
    ASSERT_NO_FATAL_FAILURE(graph.expect_shortest());
    for (int change = 0; change < kChanges; ++change) {
      graph.change();
      ASSERT_NO_FATAL_FAILURE(graph.expect_shortest());
    }
    repaired += graph.repaired();
    scratch += graph.scratch();
  }
  EXPECT_LT(repaired, scratch);
  std::cout << kGraphs << " graphs, " << kGraphs * (kChanges + 1) << " plans: " << repaired
            << " expansions repaired, " << scratch << " from scratch\n";
}

}  // namespace
}  // namespace tcert
