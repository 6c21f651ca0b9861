#pragma once
/// \file
/// The way from S to G whose narrowest edge is widest, on nodes with sides.

#include <federation/submap.hpp>

namespace tcert::federation {

/// An edge as it is driven: by its number, from end 0 to end 1 or against that.
struct WayStep {
  std::uint32_t edge = 0;
  bool is_reversed = false;
};

struct Way {
  double margin_m = -std::numeric_limits<double>::infinity();  ///< T: -infinity without a way.
  std::vector<WayStep> steps;                                  ///< From S to G.
};

/// A way enters a node by one side and leaves it by the other; an agent that turns on the spot
/// (R_min = 0) may leave it by any, and is then charged a radius of 0: a margin of 0 at most. O(n
/// log n).
[[nodiscard]] Way widest_way(std::span<const SubmapNode> nodes,
                             std::span<const SubmapEdge> edges,
                             bool turns_on_the_spot);

}  // namespace tcert::federation
