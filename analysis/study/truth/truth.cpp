#include "analysis/study/truth/truth.hpp"

#include <algorithm>
#include <utility>

#include "analysis/study/truth/curvature_value.hpp"
#include "analysis/study/truth/turning_bound.hpp"

namespace tcert::study {

ClearanceValue clearance_value(const World& world, double step_m) {
  return is_disc_field(world) ? exact_disc_clearance(world) : grid_clearance(world, step_m).value;
}

double truth_upper(const World& world, const Robot& robot, const TruthOptions& options) {
  return clearance_slack(
      clearance_value(world, options.step_m).upper_m, robot.body_width_m, options.convention);
}

Truth truth_of(const World& world, const Robot& robot, const TruthOptions& options) {
  const auto slack = [&](double clearance_m) {
    return clearance_slack(clearance_m, robot.body_width_m, options.convention);
  };
  Truth truth;
  truth.exact_clearance = is_disc_field(world);
  truth.clearance = clearance_value(world, options.step_m);
  truth.upper_m = slack(truth.clearance.upper_m);
  if (!options.curvature) {
    truth.lower_m = slack(truth.clearance.lower_m);
    return truth;
  }
  CurvatureOptions search;
  search.convention = options.convention;
  search.path_cell_m = options.path_cell_m;
  CurvatureValue found = curvature_value(world, robot, truth.upper_m, search);
  truth.lower_m = found.slack_m;
  truth.path = std::move(found.path);
  if (options.turn_cell_m > 0.0) {
    truth.upper_m = turning_upper(world,
                                  robot,
                                  options.convention,
                                  truth.lower_m,
                                  truth.upper_m,
                                  options.turn_cell_m);
  }
  return truth;
}

}  // namespace tcert::study
