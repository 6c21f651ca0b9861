#pragma once
/// \file
/// Where the beams of a CARMEN scan point.

#include <cstddef>
#include <limits>
#include <optional>

namespace tcert {

/// Beams in equal steps from right to left: beam i, from 0, at (i - straight_ahead) step_rad from
/// where the laser points.
struct CarmenBeams {
  std::size_t count = 0;
  double step_rad = 0.0;
  double straight_ahead = 0.0;  ///< Index of the beam at 0, perhaps between two or outside.
  double furthest_m = std::numeric_limits<double>::infinity();  ///< That the laser can measure.

  [[nodiscard]] double bearing_rad(std::size_t beam) const noexcept {
    return (static_cast<double>(beam) - straight_ahead) * step_rad;
  }
  friend bool operator==(const CarmenBeams&, const CarmenBeams&) = default;
};

/// The beams of a FLASER record, which says how many it has and not where they point. CARMEN's own
/// reader begins at -90 degrees and takes 1 degree between 180 and 181 beams, half a degree between
/// 360 and 361 (180 and 360 lack the last one). Other lasers have other fields of view, so any
/// other number needs `fov_rad`: its beams spread evenly from -fov_rad / 2 to +fov_rad / 2, a beam
/// at each end; so does every number if it is given. Empty where nothing is known.
/// \pre count > 0.
[[nodiscard]] std::optional<CarmenBeams> flaser_beams(std::size_t count,
                                                      std::optional<double> fov_rad) noexcept;

}  // namespace tcert
