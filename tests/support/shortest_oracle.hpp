#pragma once
/// \file
/// The stupid way to a shortest path: Dijkstra from scratch on a list of edges.

#include <array>
#include <cstdint>
#include <tcert/dstar_lite.hpp>
#include <vector>

namespace tcert::test_support {

struct CostedEdge {
  std::array<std::uint32_t, 2> ends{};
  PathCost cost = kBlocked;
};

/// Cost from every state to `goal`; kBlocked where there is no path. O(states (states + edges)).
[[nodiscard]] std::vector<PathCost> costs_by_dijkstra(std::size_t states,
                                                      const std::vector<CostedEdge>& edges,
                                                      std::uint32_t goal);

}  // namespace tcert::test_support
