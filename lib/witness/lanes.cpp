#include <algorithm>
#include <array>
#include <cstddef>
#include <witness/lanes.hpp>

namespace tcert::witness {
namespace {

/// Of each node the step that leaves it by its back, and by its front: along the widest edge of
/// those that lead on, or else of those that do not.
using Exits = std::vector<std::array<EdgeStep, 2>>;

std::size_t number_of(Side side) noexcept { return static_cast<std::size_t>(side); }

Exits best_exits(std::size_t nodes, std::span<const Edge> edges) {
  std::vector<std::array<bool, 2>> has_edge(nodes);
  for (const Edge& edge : edges) {
    for (const EdgeEnd& end : edge.ends) {
      has_edge[end.node][number_of(end.side)] = true;
    }
  }
  const auto is_better = [&](EdgeStep a, EdgeStep b) {
    const auto leads_on = [&](EdgeStep step) {
      const EdgeEnd& end = end_of(edges, step);
      return has_edge[end.node][number_of(opposite(end.side))];
    };
    return leads_on(a) != leads_on(b) ? leads_on(a)
                                      : edges[a.edge].pass.margin_m > edges[b.edge].pass.margin_m;
  };
  Exits exits(nodes);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (const bool is_reversed : {false, true}) {
      const EdgeStep step{e, is_reversed};
      const EdgeEnd& at = begin_of(edges, step);
      EdgeStep& best = exits[at.node][number_of(at.side)];
      if (best.edge == kNone || is_better(step, best)) {
        best = step;
      }
    }
  }
  return exits;
}

/// The step that follows in the lane; no edge if the lane ends.
EdgeStep next_of(EdgeStep step, const Exits& exits, std::span<const Edge> edges) {
  const EdgeEnd& at = end_of(edges, step);
  const EdgeStep back{step.edge, !step.is_reversed};
  const auto& [by_back, by_front] = exits[at.node];
  if (by_back == back) {
    return by_front;
  }
  return by_front == back ? by_back : EdgeStep{};
}

}  // namespace

std::vector<Lane> lanes_of(std::size_t nodes, std::span<const Edge> edges) {
  const Exits exits = best_exits(nodes, edges);
  std::vector<bool> is_taken(edges.size(), false);
  std::vector<Lane> lanes;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (is_taken[e]) {
      continue;
    }
    is_taken[e] = true;
    Lane behind;
    for (EdgeStep step = next_of({e, true}, exits, edges);
         step.edge != kNone && !is_taken[step.edge];
         step = next_of(step, exits, edges)) {
      is_taken[step.edge] = true;
      behind.push_back({step.edge, !step.is_reversed});
    }
    Lane lane(behind.rbegin(), behind.rend());
    lane.push_back({e, false});
    for (EdgeStep step = next_of({e, false}, exits, edges);
         step.edge != kNone && !is_taken[step.edge];
         step = next_of(step, exits, edges)) {
      is_taken[step.edge] = true;
      lane.push_back(step);
    }
    lanes.push_back(std::move(lane));
  }
  return lanes;
}

}  // namespace tcert::witness
