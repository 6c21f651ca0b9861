#pragma once
/// \file
/// Widest-path labels on a corridor graph that only grows: incremental max-min Dijkstra.

#include <cstdint>
#include <tcert/corridor_graph.hpp>
#include <vector>

namespace tcert {

/// For every state the largest, over paths from the source, of the smallest edge margin.
///
/// Sided: a state is (node, side it can be left by), so a path cannot turn round at a node.
/// Sideless: a state is a node. Since margins only rise and edges only appear, labels only rise,
/// and raising the far label of a changed edge and what follows from it keeps all labels exact.
/// Only comparisons: no arithmetic on margins. The constructor takes all memory.
class WidestLabels {
 public:
  enum class Kind { sided, sideless };
  enum class Margin { certified, felt };  ///< Which margin of an edge counts.

  WidestLabels(Kind kind, Margin margin, std::uint32_t max_nodes);

  void clear() noexcept;

  /// Sets a new node's labels to -infinity; `is_sink` ties it to the sink. \pre added in order.
  void add_node(std::uint32_t node, bool is_sink) noexcept;

  /// Raises all labels of `node` to at least `value` (the source: +infinity) and what follows.
  void raise_node(const CorridorGraph& graph, std::uint32_t node, double value) noexcept;

  /// To be called for every new edge and every edge whose margin rose.
  /// O((labels that rise + their edges) log nodes).
  void relax_edge(const CorridorGraph& graph, std::uint32_t edge) noexcept;

  /// Label of leaving `node` by `side`; -infinity if there is no path.
  [[nodiscard]] double leaving(std::uint32_t node, Side side) const noexcept {
    return label_[state_of(node, side)];
  }

  /// Largest label of the node: of reaching it at all.
  [[nodiscard]] double at(std::uint32_t node) const noexcept;

  /// Label of the sink: the widest-path value from source to sink; -infinity until connected.
  [[nodiscard]] double sink() const noexcept { return sink_; }

  /// The end by which the sink's label was last raised: a sink node and the side it is entered by.
  [[nodiscard]] EdgeEnd sink_end() const noexcept { return sink_end_; }

  /// Edge by which the label of (node, side) was last raised; kNone at a source.
  [[nodiscard]] std::uint32_t edge_into(std::uint32_t node, Side side) const noexcept {
    return via_[state_of(node, side)];
  }

  /// Labels raised since the last clear: the work done, for tests and benchmarks.
  [[nodiscard]] std::uint64_t raised() const noexcept { return raised_; }

 private:
  [[nodiscard]] std::uint32_t state_of(std::uint32_t node, Side side) const noexcept {
    return kind_ == Kind::sided ? 2 * node + static_cast<std::uint32_t>(side) : node;
  }
  [[nodiscard]] std::uint32_t node_of(std::uint32_t state) const noexcept {
    return kind_ == Kind::sided ? state / 2 : state;
  }
  void relax(const CorridorGraph& graph, std::uint32_t edge, std::uint32_t from_end) noexcept;
  void raise(std::uint32_t state, double value, std::uint32_t via) noexcept;
  void propagate(const CorridorGraph& graph) noexcept;
  [[nodiscard]] std::uint32_t pop_largest() noexcept;
  void sift_up(std::uint32_t slot) noexcept;
  void sift_down(std::uint32_t slot) noexcept;

  Kind kind_;
  Margin margin_;
  std::vector<double> label_;          // by state
  std::vector<std::uint32_t> via_;     // by state
  std::vector<std::uint32_t> heap_;    // states whose rise is not yet passed on, largest first
  std::vector<std::uint32_t> slot_;    // by state: its place in heap_, or kNone
  std::vector<std::uint8_t> is_sink_;  // by node
  double sink_;
  EdgeEnd sink_end_;
  std::uint32_t heap_size_ = 0;
  std::uint64_t raised_ = 0;
};

}  // namespace tcert
