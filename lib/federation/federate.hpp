#pragma once
/// \file
/// The certificate over what several robots know (paper 7, "certificate-preserving merge rules").

#include <federation/join.hpp>
#include <federation/submap.hpp>
#include <federation/widest_way.hpp>

namespace tcert::federation {

/// A submap as one graph: nodes and edges of all sources, numbered through, then the joins.
struct Union {
  std::vector<SubmapNode> nodes;
  std::vector<std::uint32_t> source;  ///< By node.
  std::vector<SubmapEdge> edges;
  std::size_t joins = 0;  ///< The last of the edges.
};

struct Federation {
  Union known;
  Way way;                  ///< Its margin is T_H.
  std::vector<double> own;  ///< T by source, of its own edges alone.
};

/// More pairs of nodes, or of edges at them, are not looked at, and more joins not kept.
inline constexpr std::size_t kMostPairs = 200'000'000;
inline constexpr std::size_t kMostJoins = 4'000'000;

/// Joins nodes of different sources whose frames are known, and looks for the widest way from S to
/// G. A node's margin is the largest of its own and its edges', which all pass it. If these are
/// lower bounds, frame errors are bounded as stated and S and G are those of all sources, then
/// T_H is at most T(E; A), and it is at least every source's own. The joins are of the union alone,
/// so that the order of merging never matters. O(n log n + pairs of nodes nearer than their
/// margins).
/// \throws std::length_error if there are more pairs or joins than the above.
[[nodiscard]] Federation federate(const Submap& submap);

}  // namespace tcert::federation
