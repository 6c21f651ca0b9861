#include "support/shortest_oracle.hpp"

#include <algorithm>

namespace tcert::test_support {

std::vector<PathCost> costs_by_dijkstra(std::size_t states,
                                        const std::vector<CostedEdge>& edges,
                                        std::uint32_t goal) {
  std::vector<PathCost> cost(states, kBlocked);
  std::vector<bool> settled(states, false);
  cost[goal] = 0;
  for (;;) {
    std::size_t nearest = states;
    for (std::size_t s = 0; s < states; ++s) {
      if (!settled[s] && cost[s] != kBlocked && (nearest == states || cost[s] < cost[nearest])) {
        nearest = s;
      }
    }
    if (nearest == states) {
      return cost;
    }
    settled[nearest] = true;
    for (const CostedEdge& edge : edges) {
      for (const std::size_t end : {0U, 1U}) {
        if (edge.ends[end] == nearest && edge.cost != kBlocked) {
          PathCost& far = cost[edge.ends[1 - end]];
          far = std::min(far, cost[nearest] + edge.cost);
        }
      }
    }
  }
}

}  // namespace tcert::test_support
