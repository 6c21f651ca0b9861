#include <cmath>
#include <tcert/elementary.hpp>
#include <tcert/headings.hpp>
#include <tcert/terrain_weighted.hpp>

namespace tcert::policies {

TerrainWeightedPolicy::TerrainWeightedPolicy(const PolicySetup& setup)
    : pilot_(setup),
      variance_(
          setup.robot, setup.parameters.terrain_window_m, setup.certificate.travel_deadband_m) {}

void TerrainWeightedPolicy::reset() noexcept {
  pilot_.reset();
  variance_.reset();
  travel_m_ = 0.0;
}

double TerrainWeightedPolicy::roughness(const Outlook& now, Point heading) const noexcept {
  return kernel_sum(heading, now.rays, [&](std::size_t i) noexcept { return variance_.rad2()[i]; });
}

Command TerrainWeightedPolicy::take(const Outlook& now, double turn_rad) noexcept {
  const double rough_rad2 = roughness(now, unit(turn_rad));
  const double slowed = elementary::exp(-pilot_.parameters().terrain_slowing_per_rad2 * rough_rad2);
  return pilot_.steer(now, turn_rad, pilot_.cautious_speed(now.depth) * slowed);
}

Command TerrainWeightedPolicy::step(const Senses& senses) noexcept {
  Outlook now;
  const auto settled = pilot_.begin(senses, now);
  if (!senses.tick.stale) {
    travel_m_ = std::isfinite(senses.travel_m) ? std::fmax(travel_m_, senses.travel_m) : travel_m_;
    variance_.add(travel_m_, senses.tick.rays);
  }
  if (settled) {
    return *settled;
  }
  if (now.held_turn_rad) {
    return take(now, *now.held_turn_rad);
  }
  const PolicyParameters& p = pilot_.parameters();
  HeadingCosts costs;
  add_goal_cost(costs, now.bearing_rad, p.goal_weight);
  add_clearance_cost(costs, now.rays, p.clearance_weight);
  pilot_.add_risk_cost(costs, now);
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    costs.add(k, p.terrain_weight_per_rad2 * roughness(now, HeadingCosts::heading(k)));
  }
  return take(now, turn_into(costs.cheapest(now.side), now.bearing_rad));
}

}  // namespace tcert::policies
