#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tcert/speed_law.hpp>

namespace tcert {

double gated_speed(const SpeedLaw& law, double margin_m) noexcept {
  const double z = law.beta_per_m * margin_m;
  if (std::isnan(z)) {
    return 0.0;
  }
  if (law.kind == SpeedLawKind::barrier) {
    return law.max_speed_mps;
  }
  if (law.kind == SpeedLawKind::clip || law.kind == SpeedLawKind::profile) {
    return std::lerp(law.min_speed_mps, law.max_speed_mps, std::clamp(z, 0.0, 1.0));
  }
  if (!(z > 0.0)) {
    return 0.0;
  }
  const double squashed = std::isinf(z) ? 1.0 : z / (1.0 + z);
  return std::lerp(law.min_speed_mps, law.max_speed_mps, squashed);
}

void validate(const SpeedLaw& law) {
  require_fields(law);
  if (law.max_speed_mps < law.min_speed_mps) {
    throw std::invalid_argument("max_speed_mps must not be below min_speed_mps");
  }
}

}  // namespace tcert
