#include "analysis/study/soundness/soundness_walk.hpp"

#include "analysis/study/driven/drive_case.hpp"
#include "analysis/study/driven/driver.hpp"
#include "analysis/study/soundness/soundness.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/random_run.hpp"

namespace tcert::study {

SoundnessWalk random_walk(WorldFamily family, std::uint64_t seed, std::uint64_t index) {
  const RandomWorld drawn = draw_random_world(family, seed, index);
  const double clearance_truth_m = upper_value(drawn, corpus_robot());
  const double truth_m = drawn.family == WorldFamily::u_turn
                             ? u_turn_value(drawn.corridor_m, drawn.wall_m, corpus_robot())
                             : clearance_truth_m;
  WallIndex walls = feelable_walls(drawn);
  Drive drive = follow_legs(drawn, walls, seed, index);
  return {drawn.family,
          truth_m,
          clearance_truth_m,
          drawn.lanes,
          drawn.explored,
          {drawn.world.start, drawn.world.goal},
          std::move(walls),
          std::move(drive)};
}

SoundnessWalk driven_walk(std::uint64_t seed, std::uint64_t index) {
  DrivenExperiment experiment;
  experiment.arms = paper_arms();
  experiment.seed = seed;
  experiment.parameters.drive.choice = WorldChoice::any;
  experiment.parameters.drive.control_s = kDriveStep;  // so that each control step is one of Drive
  const DrivenCase one{index % experiment.arms.size(), Lighting::indoor, index};
  const DrivenDesign design = design_of(experiment, one, index);
  Driver driver(experiment.arms[one.arm], experiment.parameters, design.world);
  DrivenRun run(design);
  Drive drive;
  while (const policies::Senses* senses = run.next()) {
    const policies::Command command = driver(*senses);
    drive.poses.push_back(run.body().pose());
    drive.speed_cmd_mps.push_back(command.speed_mps);
    drive.yaw_rate_cmd_rps.push_back(command.yaw_rate_rps);
    run.take(command);
  }
  const TrialRow row = trial_of(run).trial.row;
  drive.end_reason = row.end_reason;
  drive.time_s = row.time_s.value_or(0.0);
  drive.distance_m = row.distance_m.value_or(0.0);
  return {WorldFamily::figure_eight,
          *design.world.margin_m,
          *design.world.margin_m,
          1,
          1,
          {design.world.world.start, design.world.world.goal},
          walls_of(design.world, corpus_robot().rays.front().reach_m),
          std::move(drive)};
}

}  // namespace tcert::study
