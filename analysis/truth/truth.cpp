#include "analysis/truth/truth.hpp"

namespace tcert {

ClearanceValue clearance_value(const World& world, double step_m) {
  return is_disc_field(world) ? exact_disc_clearance(world) : grid_clearance(world, step_m).value;
}

double truth_upper(const World& world, const Robot& robot, const TruthOptions& options) {
  return clearance_slack(
      clearance_value(world, options.step_m).upper_m, robot.body_width_m, options.convention);
}

Truth truth_of(const World& world, const Robot& robot, const TruthOptions& options) {
  Truth truth;
  truth.exact_clearance = is_disc_field(world);
  truth.clearance = clearance_value(world, options.step_m);
  truth.upper_m = clearance_slack(truth.clearance.upper_m, robot.body_width_m, options.convention);
  truth.lower_m = clearance_slack(truth.clearance.lower_m, robot.body_width_m, options.convention);
  return truth;
}

}  // namespace tcert
