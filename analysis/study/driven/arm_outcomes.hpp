#pragma once
/// \file
/// What a trial of a driven bundle came to, by arm and world. Internal to paired_arms.cpp.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "datasets/bundle.hpp"

namespace tcert::study {

struct ArmOutcome {
  std::string pair;     ///< World and lighting.
  std::string cluster;  ///< Day.
  bool success = false;
  EndReason end_reason = EndReason::unknown;
  double length_m = 0.0;  ///< NaN, as the next, where it is not known.
  double time_s = 0.0;
  double peak_force_n = 0.0;
  double time_above_s = 0.0;
  double stalls = 0.0;
};

/// Of one arm, by pair.
using ArmOutcomes = std::map<std::string, ArmOutcome>;

struct OutcomesByArm {
  std::vector<std::string> arms;  ///< In the order of the trials.
  std::map<std::string, ArmOutcomes> of;
  std::size_t unknown = 0;  ///< Trials without an outcome.
};

/// Trials without an outcome are left out. \throws std::invalid_argument if there is no column
/// `pair`, or an arm has two trials of one pair.
[[nodiscard]] OutcomesByArm outcomes_by_arm(const std::vector<TrialRow>& trials,
                                            const std::vector<std::string>& extra_columns,
                                            const std::string& pair);

}  // namespace tcert::study
