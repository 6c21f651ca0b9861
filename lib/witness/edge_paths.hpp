#pragma once
/// \file
/// Paths along the edges of a corridor graph, each with the margin that it proves, which chain.

#include <optional>
#include <vector>
#include <witness/found.hpp>
#include <witness/lane_bands.hpp>
#include <witness/samples.hpp>

namespace tcert::witness {

/// The path of an edge leads from the waypoint of its end 0 to that of its end 1, see check_edge().
struct EdgePaths {
  std::vector<Pose> waypoints;                ///< By node.
  std::vector<std::optional<Witness>> paths;  ///< By edge; empty if none was found.
};

/// What paths of edges are looked for by.
struct EdgeSearchOptions {
  double merge_radius_m = 0.15;  ///< A waypoint is_near() its node by this.
  double longest_way_m = 1.0;    ///< Driven, that an edge may follow; beyond, it is its chord.
  int steps = 200;               ///< Of the band, at most: along an edge, and along every four.
};

/// Looks for a path along every edge. First the waypoints, for all paths at a node must pass it
/// alike: bands along the ways driven, one a lane, then one along every four edges of it that
/// follow each other. Then a band along each edge, its ends held. Whatever it misses only makes a
/// margin smaller. O(edges x steps) and O(edges x positions of the run) beside the space, which all
/// share.
[[nodiscard]] EdgePaths edge_paths(const EdgeProblem& problem,
                                   const Samples& samples,
                                   const EdgeSearchOptions& options);

}  // namespace tcert::witness
