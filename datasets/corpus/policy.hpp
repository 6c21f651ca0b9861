#pragma once
/// \file
/// How the six algorithms drive: declared, fitted to the published median speeds.

#include "datasets/corpus/design.hpp"

namespace tcert {

/// One algorithm under one lighting.
struct Policy {
  double cruise_mps = 0.15;           ///< Commanded in free space.
  double caution = 0.2;               ///< Share of the speed given up while a tentacle touches.
  double look_in = 0.1;               ///< Chance to look into a lane, back out and take the other.
  double pause = 0.1;                 ///< Chance to stand still for a moment at a new contact.
  double heading_noise_per_m = 0.05;  ///< Sd of the path's curvature about the commanded one.
};

[[nodiscard]] Policy policy_of(Algorithm algorithm, Lighting lighting) noexcept;

}  // namespace tcert
