#include "datasets/import/carmen_beams.hpp"

#include <numbers>

namespace tcert {

std::optional<CarmenBeams> flaser_beams(std::size_t count, std::optional<double> fov_rad) noexcept {
  constexpr double kDegree = std::numbers::pi / 180.0;
  CarmenBeams beams;
  beams.count = count;
  if (fov_rad) {
    const auto steps = static_cast<double>(count - 1);
    beams.step_rad = count > 1 ? *fov_rad / steps : 0.0;
    beams.straight_ahead = 0.5 * steps;
    return beams;
  }
  if (count == 180 || count == 181) {
    beams.step_rad = kDegree;
    beams.straight_ahead = 90.0;
    return beams;
  }
  if (count == 360 || count == 361) {
    beams.step_rad = 0.5 * kDegree;
    beams.straight_ahead = 180.0;
    return beams;
  }
  return std::nullopt;
}

}  // namespace tcert
