#pragma once
/// \file
/// The edges of a corridor graph with the paths that prove them.

#include <tcert/corridor_graph.hpp>
#include <vector>
#include <witness/edge_paths.hpp>

namespace tcert {

/// Of the nodes the poses count, of the edges the ends.
struct WitnessedEdges {
  double merge_radius_m = 0.0;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  witness::EdgePaths found;
};

}  // namespace tcert
