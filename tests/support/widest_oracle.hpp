#pragma once
/// \file
/// The stupid way to widest-path labels: a search from scratch.

#include <tcert/corridor_graph.hpp>
#include <tcert/widest_labels.hpp>
#include <vector>

namespace tcert::test_support {

/// Label of every state after a search from scratch; `source` holds what each state starts with.
/// State of (node, side): 2 node + side if sided, node if not. O(states^2 + states edges).
[[nodiscard]] std::vector<double> widest_by_search(const CorridorGraph& graph,
                                                   WidestLabels::Kind kind,
                                                   std::vector<double> source);

/// T of a certifier's graph: nodes in S are the source, nodes in G the sink.
[[nodiscard]] double certificate_by_search(const CorridorGraph& graph, bool tied_to_start);

}  // namespace tcert::test_support
