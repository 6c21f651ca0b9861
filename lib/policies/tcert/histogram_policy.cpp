#include <algorithm>
#include <cmath>
#include <tcert/histogram_policy.hpp>

namespace tcert::policies {

void HistogramPolicy::reset() noexcept {
  pilot_.reset();
  grid_.reset();
}

double HistogramPolicy::turn(const Outlook& now, const Densities& density) const noexcept {
  if (now.held_turn_rad) {
    return *now.held_turn_rad;
  }
  const int target = sector_of(now.yaw_rad + now.bearing_rad);
  const auto valley = choose_valley(density, pilot_.parameters().vfh_threshold, target, now.side);
  const double sectors = valley ? *valley : least_dense(density, target, now.side);
  return sectors == 0.0 ? now.bearing_rad : angle_between(now.yaw_rad, angle_of(target + sectors));
}

Command HistogramPolicy::step(const Senses& senses) noexcept {
  Outlook now;
  const auto settled = pilot_.begin(senses, now);
  if (now.whole) {
    grid_.take(now);
  }
  if (settled) {
    return *settled;
  }
  const PolicyParameters& p = pilot_.parameters();
  const Densities density =
      smoothed(polar_density(grid_, now.body.origin, p.vfh_reach_m, p.vfh_slope_per_m));
  const double largest_rps = pilot_.largest_yaw_rate(p.cruise_mps);
  const double rate_rps =
      std::clamp(p.heading_gain_per_s * now.sided(turn(now, density)), -largest_rps, largest_rps);
  const double ahead = std::min(density[sector_index(sector_of(now.yaw_rad))], p.vfh_high_density);
  const double speed_mps = (p.cruise_mps - p.vfh_min_speed_mps) *
                               (1.0 - ahead / p.vfh_high_density) *
                               (1.0 - std::abs(rate_rps) / largest_rps) +
                           p.vfh_min_speed_mps;
  return pilot_.drive(speed_mps, rate_rps);
}

}  // namespace tcert::policies
