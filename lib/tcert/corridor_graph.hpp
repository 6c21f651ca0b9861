#pragma once
/// \file
/// The explored-corridor graph G_t of one trial (paper 3.1).

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Side of a node, relative to its heading. A path that enters by one leaves by the other.
enum class Side : std::uint8_t { back = 0, front = 1 };

[[nodiscard]] constexpr Side opposite(Side side) noexcept {
  return side == Side::back ? Side::front : Side::back;
}

/// An end of an edge: the side of the node that it attaches to.
struct EdgeEnd {
  std::uint32_t node = kNone;
  Side side = Side::front;
  friend bool operator==(const EdgeEnd&, const EdgeEnd&) = default;
};

/// Five-number summary of a quantity along an edge.
struct Profile {
  double min = 0.0, p05 = 0.0, p50 = 0.0, p95 = 0.0, max = 0.0;
};

/// What one pass along an edge felt.
struct Pass {
  double margin_m = 0.0;  ///< Smallest tick margin.
  Pose narrowest;         ///< Of the first tick with that margin.
  double width_m = 0.0;   ///< At that tick.
  double turn_radius_m = 0.0;
  Profile width;
  Profile turn_radius;
};

struct Node {
  Pose pose;
  Point heading;          ///< Unit vector of the pose's yaw.
  bool in_start = false;  ///< Tied to the source.
  bool in_goal = false;   ///< Tied to the sink.
};

/// A margin that T_t counts on, and where it was decided.
struct Certified {
  double margin_m = 0.0;
  Pose narrowest;
  double width_m = 0.0;
  double turn_radius_m = 0.0;
};

/// Undirected; `pass` is the pass with the largest margin so far, so the margin never falls, and
/// no more does what is certified. That is less where the pass changes over to a known node, and
/// under `clearance=swept` it is of what was swept.
struct Edge {
  std::array<EdgeEnd, 2> ends;
  Pass pass;            ///< By what was felt at once: for V_t.
  Certified certified;  ///< For T_t.
};

/// Nodes, edges and adjacency in memory taken by the constructor; a member that needs more says
/// so by returning kNone. All members but the constructor are noexcept and allocate nothing.
class CorridorGraph {
 public:
  /// `cell_m` is the cell of the node look-up: about the largest radius that is looked up.
  CorridorGraph(std::uint32_t max_nodes, std::uint32_t max_edges, double cell_m);

  void clear() noexcept;

  /// Index of the new node, or kNone if the graph is full. O(1).
  std::uint32_t add_node(const Node& node) noexcept;

  struct Recorded {
    std::uint32_t edge = kNone;  ///< kNone iff a new edge was needed and the graph is full.
    bool changed = false;        ///< The edge is new or its margin rose.
  };

  /// Records a pass between two ends: a new edge, or perhaps a larger margin of the edge that has
  /// the same ends. O(edges at the first end).
  Recorded record_pass(EdgeEnd a, EdgeEnd b, const Pass& pass) noexcept;
  /// The same with a margin for T_t of its own.
  Recorded record_pass(EdgeEnd a, EdgeEnd b, const Pass& pass, const Certified& certified) noexcept;

  /// Index of the edge with these ends; kNone if there is none. O(edges at the first end).
  [[nodiscard]] std::uint32_t find_edge(EdgeEnd a, EdgeEnd b) const noexcept;

  /// Raises what is certified of an edge; false if it is no more than before.
  bool certify(std::uint32_t edge, const Certified& certified) noexcept;

  [[nodiscard]] std::span<const Node> nodes() const noexcept;
  [[nodiscard]] std::span<const Edge> edges() const noexcept;
  [[nodiscard]] bool nodes_full() const noexcept { return node_count_ == nodes_.size(); }
  [[nodiscard]] bool edges_full() const noexcept { return edge_count_ == edges_.size(); }

  /// Calls `visit(edge index, which end of it is at the node)` for every edge at `node`.
  template <typename Visit>
  void for_each_edge_at(std::uint32_t node, Visit visit) const noexcept {
    for (std::uint32_t half = first_half_[node]; half != kNone; half = next_half_[half]) {
      visit(half / 2, half % 2);
    }
  }

  /// Calls `visit(node index)` for every node within the box `low`..`high`, and for some outside.
  template <typename Visit>
  void for_each_node_near(Point low, Point high, Visit visit) const noexcept {
    const Cell from = cell_of(low);
    const Cell to = cell_of(high);
    for (std::int64_t iy = from.iy; iy <= to.iy; ++iy) {
      for (std::int64_t ix = from.ix; ix <= to.ix; ++ix) {
        for (std::uint32_t n = bucket_[bucket_of({ix, iy})]; n != kNone; n = next_in_bucket_[n]) {
          visit(n);
        }
      }
    }
  }

 private:
  struct Cell {
    std::int64_t ix = 0;
    std::int64_t iy = 0;
  };
  [[nodiscard]] Cell cell_of(Point p) const noexcept;
  [[nodiscard]] std::size_t bucket_of(Cell cell) const noexcept;

  double cell_m_;
  std::uint32_t node_count_ = 0;
  std::uint32_t edge_count_ = 0;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> first_half_;      // by node; half edge 2e + end
  std::vector<std::uint32_t> next_half_;       // by half edge
  std::vector<std::uint32_t> bucket_;          // hash of a cell -> newest node; a power of two
  std::vector<std::uint32_t> next_in_bucket_;  // by node
};

}  // namespace tcert
