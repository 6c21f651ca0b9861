#include <tcert/headings.hpp>
#include <tcert/memory_augmented.hpp>

namespace tcert::policies {

void MemoryPolicy::reset() noexcept {
  pilot_.reset();
  memory_.reset();
}

Command MemoryPolicy::step(const Senses& senses) noexcept {
  Outlook now;
  const auto settled = pilot_.begin(senses, now);
  if (now.whole) {
    memory_.take(now, senses);
  }
  if (settled) {
    return *settled;
  }
  const PolicyParameters& p = pilot_.parameters();
  const double speed_mps = pilot_.cautious_speed(now.depth);
  if (now.held_turn_rad) {
    return pilot_.steer(now, *now.held_turn_rad, speed_mps);
  }
  HeadingCosts costs;
  add_goal_cost(costs, now.bearing_rad, p.goal_weight);
  add_clearance_cost(costs, now.rays, p.clearance_weight);
  pilot_.add_risk_cost(costs, now);
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    const Point ahead = now.body.turned(HeadingCosts::heading(k));
    costs.add(k, p.risk_weight * memory_.mean_along(now.body.origin, ahead, p.memory_ahead_m));
  }
  const int k = costs.cheapest(now.side);
  return pilot_.steer(now, turn_into(k, now.bearing_rad), speed_mps);
}

}  // namespace tcert::policies
