#include "analysis/study/driven/drive_case.hpp"

#include "analysis/study/driven/driver.hpp"

namespace tcert::study {

DrivenDesign design_of(const DrivenExperiment& experiment,
                       const DrivenCase& one,
                       std::uint64_t index) {
  DrivenDesign design = design_driven(experiment.parameters.drive, experiment.seed, one.world);
  const Arm& arm = experiment.arms.at(one.arm);
  design.trial_id = trial_name(index);
  design.algorithm = arm.name;
  design.lighting = one.lighting;
  design.camera = arm.policy == policies::PolicyKind::cb_v;
  design.truth = experiment.truth;
  design.native_rates = experiment.native_rates;
  return design;
}

DrivenTrial drive_case(const DrivenExperiment& experiment,
                       const DrivenCase& one,
                       std::uint64_t index) {
  const DrivenDesign design = design_of(experiment, one, index);
  return drive_trial(
      design,
      Driver(experiment.arms[one.arm], experiment.parameters, design.world, experiment.rules));
}

}  // namespace tcert::study
