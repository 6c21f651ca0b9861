#pragma once
/// \file
/// D* Lite (Koenig and Likhachev 2002, the optimised version): shortest paths to a goal that are
/// repaired, not searched again, when costs change and the start moves.

#include <array>
#include <cstdint>
#include <limits>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert {

/// Costs are whole micrometres, inflated: sums are exact, so a repaired path costs to the unit what
/// a search from scratch finds.
using PathCost = std::int64_t;

/// A blocked edge, a state that cannot reach the goal.
inline constexpr PathCost kBlocked = std::numeric_limits<PathCost>::max();

/// An undirected multigraph of states in the plane with its search. A cost is never less than the
/// straight distance of its ends (it is raised to that), which the heuristic needs; it must stay
/// below 2^62 along a path.
///
/// The constructor takes all memory; every other member is noexcept and allocates nothing.
class DStarLite {
 public:
  static constexpr std::uint32_t kNoState = std::numeric_limits<std::uint32_t>::max();

  DStarLite(std::uint32_t max_states, std::uint32_t max_edges);

  void clear() noexcept;

  /// Index of the new state, kNoState if there is no room.
  std::uint32_t add_state(Point position) noexcept;

  /// Index of the new edge, kNoState if there is no room. \pre a and b are states.
  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, PathCost cost) noexcept;

  /// Another cost; kBlocked closes the edge. O(edges at its ends).
  void set_cost(std::uint32_t edge, PathCost cost) noexcept;
  [[nodiscard]] PathCost cost(std::uint32_t edge) const noexcept { return edges_[edge].cost; }

  /// Another goal: the search starts anew. \pre a state.
  void set_goal(std::uint32_t goal) noexcept;
  void set_start(std::uint32_t start) noexcept;

  /// Repairs the search; the cost of the shortest path from start to goal, kBlocked if there is
  /// none. \pre start and goal are set.
  PathCost plan() noexcept;

  /// Forgets the search, not the graph: the next plan starts from scratch.
  void forget() noexcept;

  /// Where the shortest path leaves `state`, and by which edge; ties: the edge of lowest index.
  /// kNoState at the goal and where there is no path. Exact for states on the path of the last
  /// plan.
  struct Step {
    std::uint32_t state = kNoState;
    std::uint32_t edge = kNoState;
  };
  [[nodiscard]] Step next(std::uint32_t state) const noexcept;

  /// The cost from a state to the goal. Exact for every state after the start on any shortest path
  /// of the last plan, so that a caller may choose among them by a rule of its own: such a state's
  /// key lies below that of the start, where a plan ends.
  [[nodiscard]] PathCost cost_to_goal(std::uint32_t state) const noexcept { return g_[state]; }

  /// States expanded since the last clear: the work of the search.
  [[nodiscard]] std::uint64_t expansions() const noexcept { return expansions_; }
  [[nodiscard]] std::uint32_t states() const noexcept { return state_count_; }
  [[nodiscard]] std::uint32_t edges() const noexcept { return edge_count_; }

 private:
  struct Edge {
    std::array<std::uint32_t, 2> ends{};
    PathCost cost = kBlocked;
  };
  struct Key {
    PathCost first = kBlocked;
    PathCost second = kBlocked;
    friend bool operator<(const Key& a, const Key& b) noexcept {
      return a.first != b.first ? a.first < b.first : a.second < b.second;
    }
  };

  [[nodiscard]] PathCost distance_between(std::uint32_t a, std::uint32_t b) const noexcept;
  [[nodiscard]] Key key_of(std::uint32_t state) const noexcept;
  [[nodiscard]] PathCost best_successor(std::uint32_t state) const noexcept;
  void cost_changed(std::uint32_t state,
                    std::uint32_t other,
                    PathCost before,
                    PathCost now) noexcept;
  void update_state(std::uint32_t state) noexcept;
  void lower_neighbours(std::uint32_t state) noexcept;
  void raise_neighbours(std::uint32_t state) noexcept;

  // Heap of inconsistent states, smallest key first.
  void insert(std::uint32_t state, Key key) noexcept;
  void remove(std::uint32_t state) noexcept;
  void move_up(std::uint32_t slot) noexcept;
  void move_down(std::uint32_t slot) noexcept;
  void place(std::uint32_t slot, std::uint32_t state) noexcept;

  std::uint32_t state_count_ = 0;
  std::uint32_t edge_count_ = 0;
  std::vector<Point> position_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> first_half_;  // by state; half edge 2e + end
  std::vector<std::uint32_t> next_half_;
  std::vector<PathCost> g_;
  std::vector<PathCost> rhs_;
  std::vector<Key> key_;  // of states in the heap
  std::vector<std::uint32_t> heap_;
  std::vector<std::uint32_t> slot_;  // by state, kNoState if not in the heap
  std::uint32_t heap_size_ = 0;
  std::uint32_t start_ = kNoState;
  std::uint32_t goal_ = kNoState;
  PathCost shift_ = 0;  // k_m
  std::uint64_t expansions_ = 0;
};

}  // namespace tcert
