#pragma once
/// \file
/// Where a certificate is decided.

#include <cstdint>
#include <optional>
#include <tcert/geometry.hpp>

namespace tcert {

class CorridorWalk;

struct Bottleneck {
  std::uint32_t edge = 0;
  Pose pose;  ///< Of the tick with the smallest margin on that edge.
  double margin_m = 0.0;
  double width_m = 0.0;
  double turn_radius_m = 0.0;
};

/// The first of the narrowest edges of the path that T_t is of, from G; its margin is T_t. Of a
/// path that turns on the spot it is at most 0, with a turn radius of 0. Empty without a path, and
/// if S and G meet without an edge. O(edges of the path).
/// `since_start_m` as of CorridorWalk::certificate_m().
[[nodiscard]] std::optional<Bottleneck> bottleneck_of(const CorridorWalk& walk,
                                                      double since_start_m = 0.0) noexcept;

}  // namespace tcert
