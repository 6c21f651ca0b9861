#include <cmath>
#include <stdexcept>
#include <string>
#include <tcert/policy_setup.hpp>

namespace tcert::policies {
namespace {

/// Entries of M2's queue over travel, and cells along what is walked in one step.
constexpr double kMostSteps = 1000.0;
/// Cells along a length of which the square is looked at in one step.
constexpr double kMostSquared = 64.0;
/// b d_max of TVFH.
constexpr double kMostNearness = 1000.0;

/// `larger` of at most `most` times `smaller`.
void require_ratio(const std::string& name,
                   double larger,
                   const char* smaller_name,
                   double smaller,
                   double most = kMostSteps) {
  if (!(larger <= most * smaller)) {
    throw std::invalid_argument(name + " is " + to_text(larger) + "; it must be at most " +
                                to_text(most) + " times " + smaller_name + ", which is " +
                                to_text(smaller));
  }
}

void require_at_most(const char* name, double value, const char* limit_name, double limit) {
  if (!(value <= limit)) {
    throw std::invalid_argument(std::string(name) + " is " + to_text(value) +
                                "; it must be at most " + limit_name + ", which is " +
                                to_text(limit));
  }
}

}  // namespace

void validate(const PolicyParameters& p) {
  require_fields(p);
  require_at_most("stall_moved_m", p.stall_moved_m, "stall_pushed_m", p.stall_pushed_m);
  require_at_most("vfh_reach_m times vfh_slope_per_m",
                  p.vfh_reach_m * p.vfh_slope_per_m,
                  "what keeps sums exact",
                  kMostNearness);
  require_at_most("vfh_min_speed_mps", p.vfh_min_speed_mps, "cruise_mps", p.cruise_mps);
}

void validate(const PolicySetup& setup) {
  validate(setup.robot, setup.certificate);
  validate(setup.parameters);
  validate(setup.line);
  require_in_bounds({"control_period_s", "s", from(1e-3, 1.0), {}}, setup.control_period_s);
  if (setup.robot.rays.size() > kMostRays) {
    throw std::invalid_argument("a policy takes at most " + std::to_string(kMostRays) + " rays");
  }
  const PolicyParameters& p = setup.parameters;
  const double cell_m = p.policy_cell_m;
  require_ratio("terrain_window_m",
                p.terrain_window_m,
                "travel_deadband_m",
                setup.certificate.travel_deadband_m);
  require_ratio(
      "memory_ahead_m", p.memory_ahead_m, "memory_cell_m", setup.certificate.memory_cell_m);
  require_ratio("vfh_reach_m", p.vfh_reach_m, "policy_cell_m", cell_m, kMostSquared);
  require_ratio("body_width_m", setup.robot.body_width_m, "policy_cell_m", cell_m, kMostSquared);
  require_ratio("lookahead_m", p.lookahead_m, "policy_cell_m", cell_m, kMostSquared);
  for (const Ray& ray : setup.robot.rays) {
    require_ratio("reach_m of ray '" + ray.name + "'", ray.reach_m, "policy_cell_m", cell_m);
  }
}

}  // namespace tcert::policies
