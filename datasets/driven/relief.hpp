#pragma once
/// \file
/// Ramps and steps of a driven world: what they take of the legs' way, and what a robot feels of
/// them. Declared, not measured on a robot.

#include <span>
#include <tcert/region.hpp>
#include <tcert/tick.hpp>
#include <vector>

#include "datasets/driven/drive_parameters.hpp"

namespace tcert {

/// Where the ground is not level: within `area` it rises by `slope` along `up`, and to its middle a
/// step of `step_m` leads up, from whichever side.
struct ReliefPatch {
  Disc area;
  Point up{1.0, 0.0};  ///< Unit vector.
  double slope = 0.0;  ///< tan theta.
  double step_m = 0.0;
};

/// Without noise and without slip. Level ground has zeros; angles by which the plane of the ground
/// is pitched along the heading, nose up, and then rolled, left side up.
[[nodiscard]] Footing footing_at(std::span<const ReliefPatch> relief, const Pose& pose) noexcept;

/// Share of the legs' way, 0 to 1, that is lost while the body moves along the unit vector `along`:
/// (grade / slope_limit)^2 uphill, (step / step_limit)^2 up a step, nothing downhill.
[[nodiscard]] double tread_loss(std::span<const ReliefPatch> relief,
                                Point at,
                                Point along,
                                const DriveParameters& parameters) noexcept;

/// A ramp and a step on lanes of a world, each with its declared probability, by `seed` and `index`
/// alone; up along the lane or against it. Heights of one world share gate_correlation, as gates
/// do. Nothing is drawn if both shares are 0.
[[nodiscard]] std::vector<ReliefPatch> draw_relief(
    const DriveParameters& parameters,
    const std::vector<std::vector<std::vector<Point>>>& lobes,
    std::uint64_t seed,
    std::uint64_t index);

}  // namespace tcert
