#pragma once
/// \file
/// What a reading of a ray says: one rule for the certificate, the witness and the policies.

#include <algorithm>
#include <cmath>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>

namespace tcert {

/// The clearance in m that a reading states, clamped to [0, reach]; NaN of what is not finite.
/// O(log knots).
[[nodiscard]] inline double felt_clearance(const Ray& ray, double value) noexcept {
  if (!std::isfinite(value)) {
    return kMissing;
  }
  const double stated_m =
      ray.kind == RayKind::bend ? calibrated_clearance(ray.calibration, value) : value;
  return std::clamp(stated_m, 0.0, ray.reach_m);
}

/// The same of a reading that may state its own bearing: NaN, too, if that is none.
[[nodiscard]] inline double felt_clearance(const Ray& ray, const RayReading& reading) noexcept {
  return is_usable_bearing(reading.bearing_rad) ? felt_clearance(ray, reading.value) : kMissing;
}

}  // namespace tcert
