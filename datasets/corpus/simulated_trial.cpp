#include "datasets/corpus/simulated_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "datasets/corpus/drive.hpp"
#include "datasets/corpus/purpose.hpp"
#include "datasets/corpus/streams.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/corpus/trial_course.hpp"

namespace tcert {
namespace {

// Tight lobes are driven more slowly, so that the way takes as long in all of them.
constexpr double kTypicalRadius = 0.8;

/// How a failure shows: most wedge, some are stopped after a push, some try until time is up.
EndReason ending(table::RandomStream& random) {
  const double u = random.uniform();
  if (u < 0.65) {
    return EndReason::wedged;
  }
  return u < 0.85 ? EndReason::collision : EndReason::timeout;
}

DrivePlan plan_drive(const TrialDesign& design,
                     const TrialCourse& trial,
                     table::RandomStream& random) {
  DrivePlan plan;
  plan.policy = policy_of(design.algorithm, design.lighting);
  plan.policy.cruise_mps *= lane_length(trial.course) / lane_length({kTypicalRadius, 1.2});
  const bool look_in = random.uniform() < plan.policy.look_in;
  const double look_in_m = random.uniform(0.5, 1.0);
  plan.when_stuck = ending(random);
  plan.legs = plan_legs(trial, look_in, look_in_m);
  plan.start = lane_pose(trial.course, trial.route.first, 0.0);
  plan.goal = course_goal();
  plan.graded_caution = std::min(design.effect, 1.0);
  return plan;
}

}  // namespace

std::vector<std::string> corpus_extra_columns() { return {"true_margin_m"}; }

SimulatedTrial simulate_trial(const TrialDesign& design) {
  const TrialCourse trial = draw_course(design);
  SimulatedTrial simulated;
  simulated.world = build_world(trial.course, trial.gates);
  simulated.world.name = trial_name(design.index);
  simulated.world.seed = design.seed;
  simulated.true_margin_m = trial.true_margin_m;

  const WallIndex walls(simulated.world, kSensingRange);
  table::RandomStream random(design.seed, draws::kDrive, 2 * design.index);
  const DrivePlan plan = plan_drive(design, trial, random);
  const Drive driven =
      drive(plan, walls, table::RandomStream(design.seed, draws::kDrive, 2 * design.index + 1));
  if ((driven.end_reason == EndReason::goal) != design.success) {
    throw std::logic_error(fmt::format("trial {} of seed {} was designed to {}, but did not",
                                       design.index,
                                       design.seed,
                                       design.success ? "reach G" : "fail"));
  }
  simulated.log = log_drive(driven,
                            walls,
                            {design.noise_seed.value_or(design.seed),
                             design.index,
                             design.native_rates,
                             design.day_calibration_m});

  TrialRow& row = simulated.row;
  row.trial_id = trial_name(design.index);
  row.algorithm = name_of(design.algorithm);
  row.lighting = name_of(design.lighting);
  row.day = fmt::format("D{:02}", design.day + 1);
  row.batch = fmt::format("B{:02}", design.day + 1);
  row.success = design.success;
  row.time_s = driven.time_s;
  row.distance_m = driven.distance_m;
  row.end_reason = driven.end_reason;
  row.extra = {fmt::format("{:.4f}", trial.true_margin_m)};
  return simulated;
}

}  // namespace tcert
