#pragma once
/// \file
/// Paths of edges put one behind the other.

#include <span>
#include <tcert/corridor_graph.hpp>
#include <tcert/region.hpp>
#include <vector>
#include <witness/edge_paths.hpp>
#include <witness/lanes.hpp>

namespace tcert::witness {

/// The steps from S to G of which the smallest margin is largest, entering every node by one side
/// and leaving it by the other; a path begins at a waypoint in S and ends at one in G. None if
/// there is no such chain. O(edges log nodes).
[[nodiscard]] std::vector<EdgeStep> widest_chain(const EdgePaths& found,
                                                 std::span<const Edge> edges,
                                                 const Region& start,
                                                 const Region& goal);

/// The path of the steps. Where each enters a node by the side opposite to the one that the next
/// leaves it by it is tangent at the waypoint, so that its margin is the smallest of theirs, to
/// 1e-9 m. \pre each step has a path and begins at the node where the one before ends.
[[nodiscard]] Path chained(const EdgePaths& found, std::span<const EdgeStep> steps);

}  // namespace tcert::witness
