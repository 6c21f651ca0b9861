#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tcert/speed_profile.hpp>

namespace tcert {

void limit_profile(std::span<double> speeds,
                   double step_m,
                   double now_mps,
                   double accel_mps2,
                   double brake_mps2) noexcept {
  if (speeds.empty()) {
    return;
  }
  speeds[0] = std::min(speeds[0], now_mps);
  for (std::size_t k = 1; k < speeds.size(); ++k) {
    const double gained = std::sqrt(speeds[k - 1] * speeds[k - 1] + 2.0 * accel_mps2 * step_m);
    speeds[k] = std::min(speeds[k], gained);
  }
  for (std::size_t k = speeds.size() - 1; k > 0; --k) {
    const double braked = std::sqrt(speeds[k] * speeds[k] + 2.0 * brake_mps2 * step_m);
    speeds[k - 1] = std::min(speeds[k - 1], braked);
  }
}

double profile_speed(const SpeedLaw& law,
                     double limit_mps,
                     double front_m,
                     double last_mps,
                     double period_s) noexcept {
  constexpr std::size_t kPlaces = 16;
  const double gained_mps = last_mps + law.accel_mps2 * period_s;
  const double wanted_mps = std::min(limit_mps, gained_mps);
  // The way of the period itself is driven at the new speed; what is left of it is for braking.
  const double left_m = std::max(front_m - wanted_mps * period_s, 0.0);
  std::array<double, kPlaces + 1> speeds{};
  std::fill(speeds.begin(), speeds.end() - 1, limit_mps);
  speeds.back() = std::min(law.min_speed_mps, limit_mps);
  if (left_m == 0.0) {
    return speeds.back();
  }
  limit_profile(speeds, left_m / kPlaces, wanted_mps, law.accel_mps2, law.brake_mps2);
  return std::max(speeds.front(), speeds.back());
}

}  // namespace tcert
