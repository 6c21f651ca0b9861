#include <algorithm>
#include <cmath>
#include <tcert/camera_policy.hpp>

namespace tcert::policies {

SeenRays seen_rays(std::span<const Sighting> sightings, double near_m) noexcept {
  SeenRays rays;
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    rays[static_cast<std::size_t>(k - HeadingCosts::kLowest)].ahead = HeadingCosts::heading(k);
  }
  for (const Sighting& sighting : sightings) {
    const double range_m = std::max(sighting.range_m, 0.0);
    if (!std::isfinite(sighting.bearing_rad) || !(range_m < near_m)) {
      continue;
    }
    const double bearing_rad = wrapped_angle(sighting.bearing_rad);
    const int k = static_cast<int>(std::round(bearing_rad / HeadingCosts::turn_rad(1)));
    const int same = k < HeadingCosts::kLowest ? HeadingCosts::kHighest : k;
    FeltRay& ray = rays[static_cast<std::size_t>(same - HeadingCosts::kLowest)];
    ray.clearance_m = std::fmin(ray.clearance_m, range_m);
    ray.depth = (near_m - ray.clearance_m) / near_m;
  }
  return rays;
}

Command CameraPolicy::step(const Senses& senses) noexcept {
  Outlook now;
  if (const auto settled = pilot_.begin(senses, now)) {
    return *settled;
  }
  const PolicyParameters& p = pilot_.parameters();
  const SeenRays seen = seen_rays(senses.camera, p.camera_near_m);
  const double speed_mps = pilot_.cautious_speed(deepest(seen));
  if (now.held_turn_rad) {
    return pilot_.steer(now, *now.held_turn_rad, speed_mps);
  }
  HeadingCosts costs;
  add_goal_cost(costs, now.bearing_rad, p.goal_weight);
  add_clearance_cost(costs, seen, p.clearance_weight);
  pilot_.add_risk_cost(costs, now);
  return pilot_.steer(now, turn_into(costs.cheapest(now.side), now.bearing_rad), speed_mps);
}

}  // namespace tcert::policies
