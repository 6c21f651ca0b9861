#include <tcert/headings.hpp>
#include <tcert/reactive.hpp>

namespace tcert::policies {

Command ReactivePolicy::step(const Senses& senses) noexcept {
  Outlook now;
  if (const auto settled = pilot_.begin(senses, now)) {
    return *settled;
  }
  const double speed_mps = pilot_.cautious_speed(now.depth);
  if (now.held_turn_rad) {
    return pilot_.steer(now, *now.held_turn_rad, speed_mps);
  }
  HeadingCosts costs;
  add_goal_cost(costs, now.bearing_rad, pilot_.parameters().goal_weight);
  add_clearance_cost(costs, now.rays, pilot_.parameters().clearance_weight);
  pilot_.add_risk_cost(costs, now);
  const int k = costs.cheapest(now.side);
  return pilot_.steer(now, turn_into(k, now.bearing_rad), speed_mps);
}

}  // namespace tcert::policies
