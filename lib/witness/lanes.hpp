#pragma once
/// \file
/// The edges of a corridor graph as lanes: edges that follow each other through their nodes.

#include <cstdint>
#include <span>
#include <tcert/corridor_graph.hpp>
#include <vector>

namespace tcert::witness {

/// An edge as a way along the graph takes it: from its end 0 to its end 1, or back.
struct EdgeStep {
  std::uint32_t edge = kNone;
  bool is_reversed = false;
  friend bool operator==(const EdgeStep&, const EdgeStep&) = default;
};

/// The end by which a step leaves, or enters, a node.
[[nodiscard]] inline const EdgeEnd& begin_of(std::span<const Edge> edges, EdgeStep step) noexcept {
  return edges[step.edge].ends[step.is_reversed ? 1 : 0];
}
[[nodiscard]] inline const EdgeEnd& end_of(std::span<const Edge> edges, EdgeStep step) noexcept {
  return edges[step.edge].ends[step.is_reversed ? 0 : 1];
}

using Lane = std::vector<EdgeStep>;

/// Every edge in one lane. Through a node lead the best edge at its back and that at its front: the
/// widest, by the margin felt, of those that do not end at their other node, if there are any. At
/// all others a lane ends. A ring is cut where its first edge begins.
/// O(nodes + edges).
[[nodiscard]] std::vector<Lane> lanes_of(std::size_t nodes, std::span<const Edge> edges);

}  // namespace tcert::witness
