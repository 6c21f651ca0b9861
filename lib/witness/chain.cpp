#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <tcert/widest_labels.hpp>
#include <witness/chain.hpp>

namespace tcert::witness {

std::vector<EdgeStep> widest_chain(const EdgePaths& found,
                                   std::span<const Edge> edges,
                                   const Region& start,
                                   const Region& goal) {
  const auto nodes = static_cast<std::uint32_t>(found.waypoints.size());
  CorridorGraph graph(nodes, static_cast<std::uint32_t>(edges.size()), 1.0);
  WidestLabels labels(WidestLabels::Kind::sided, WidestLabels::Margin::certified, nodes);
  for (std::uint32_t n = 0; n < nodes; ++n) {
    const Pose& waypoint = found.waypoints[n];
    const bool is_sink = contains(goal, waypoint.position);
    graph.add_node({waypoint, direction(waypoint.yaw_rad), false, is_sink});
    labels.add_node(n, is_sink);
  }
  std::vector<std::uint32_t> edge_of;  // the graph holds those with a path alone
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (found.paths[e]) {
      const double margin_m = found.paths[e]->checked.margin_m;
      graph.record_pass(edges[e].ends[0], edges[e].ends[1], {margin_m, {}, 0.0, 0.0, {}, {}});
      edge_of.push_back(e);
    }
  }
  for (std::uint32_t n = 0; n < nodes; ++n) {
    if (contains(start, found.waypoints[n].position)) {
      labels.raise_node(graph, n, std::numeric_limits<double>::infinity());
    }
  }
  std::vector<EdgeStep> steps;
  EdgeEnd entered = labels.sink_end();
  while (entered.node != kNone) {
    const std::uint32_t into = labels.edge_into(entered.node, opposite(entered.side));
    if (into == kNone) {
      break;
    }
    const std::array<EdgeEnd, 2>& ends = graph.edges()[into].ends;
    const bool is_reversed = ends[0] == entered;
    steps.push_back({edge_of[into], is_reversed});
    const EdgeEnd& from = ends[is_reversed ? 1 : 0];
    entered = {from.node, opposite(from.side)};
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

Path chained(const EdgePaths& found, std::span<const EdgeStep> steps) {
  Path path;
  for (const EdgeStep step : steps) {
    const Path& one = found.paths[step.edge]->path;
    if (!step.is_reversed) {
      path.insert(path.end(), one.begin(), one.end());
      continue;
    }
    std::transform(one.rbegin(), one.rend(), std::back_inserter(path), [](const Piece& piece) {
      return Piece{piece.to, piece.from, -piece.turn_rad};
    });
  }
  return path;
}

}  // namespace tcert::witness
