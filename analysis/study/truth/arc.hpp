#pragma once
/// \file
/// A stretch of a path of constant curvature, and how clear it is.

#include <tcert/geometry.hpp>

#include "analysis/study/truth/obstacle_distance.hpp"

namespace tcert::study {

struct Arc {
  Pose from;
  double curvature_per_m = 0.0;  ///< Positive to the left.
  double length_m = 0.0;
};

/// Pose at `along_m` of the arc.
[[nodiscard]] Pose pose_at(const Arc& arc, double along_m) noexcept;

/// A lower bound, at most `tolerance_m` too low, of the least distance to an obstacle along the
/// arc. Distance changes by no more than the way, so a stretch of length L whose middle is d clear
/// is at least d - L / 2 clear; stretches are halved until that settles it.
[[nodiscard]] double arc_clearance(const Arc& arc,
                                   const ObstacleDistance& obstacles,
                                   double tolerance_m) noexcept;

}  // namespace tcert::study
