#pragma once
/// \file
/// One trial of an experiment, driven.

#include <cstdint>
#include <tcert/rule_formula.hpp>
#include <vector>

#include "analysis/study/driven/driven_cases.hpp"
#include "analysis/study/trials/parameters.hpp"
#include "datasets/driven/driven_trial.hpp"

namespace tcert::study {

struct DrivenExperiment {
  std::vector<Arm> arms;
  ParameterSet parameters;
  std::uint64_t seed = 1;
  bool native_rates = false;
  bool truth = false;         ///< Also keep truth.csv.
  std::vector<Rule> rules{};  ///< That arms with a monitor watch.
};

/// Its design: the world, the noise and the crash force belong to (seed, world), so that two arms
/// that meet a world meet the same one; `index` names the trial.
[[nodiscard]] DrivenDesign design_of(const DrivenExperiment& experiment,
                                     const DrivenCase& one,
                                     std::uint64_t index);

/// Drives it. The same experiment and case give the same trial, bit for bit, on any thread.
/// \throws std::invalid_argument if a parameter is out of range.
[[nodiscard]] DrivenTrial drive_case(const DrivenExperiment& experiment,
                                     const DrivenCase& one,
                                     std::uint64_t index);

}  // namespace tcert::study
