#include <algorithm>
#include <cmath>
#include <tcert/speed_gate.hpp>

namespace tcert::policies {

Command at_granted_speed(const Command& wanted,
                         double granted_mps,
                         const PolicyParameters& parameters) noexcept {
  if (!(wanted.speed_mps > 0.0)) {
    return wanted;
  }
  const double caution = std::min(wanted.speed_mps / parameters.cruise_mps, 1.0);
  const double speed_mps = caution * std::fmax(granted_mps, parameters.creep_mps);
  const double rate_rps = wanted.yaw_rate_rps * (speed_mps / wanted.speed_mps);
  const double most_rps = parameters.max_yaw_rate_rps;
  if (std::abs(rate_rps) > most_rps) {
    return {speed_mps * (most_rps / std::abs(rate_rps)), std::copysign(most_rps, rate_rps)};
  }
  return {speed_mps, rate_rps};
}

}  // namespace tcert::policies
