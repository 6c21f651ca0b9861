#pragma once
/// \file
/// A studied trial at every speed law of a grid: what `replay` and H3 do with each trial.

#include <optional>
#include <tcert/runtime.hpp>
#include <vector>

#include "analysis/study/replay/replay_record.hpp"
#include "analysis/study/trials/parameters.hpp"
#include "analysis/study/trials/study.hpp"
#include "datasets/bundle.hpp"

namespace tcert::study {

struct ReplaySetup {
  std::vector<SpeedLaw> laws;
  TrackingErrorTable tracking_error;
  std::vector<Rule> rules;  ///< That are monitored.
  bool risk = false;        ///< Keep a risk field.
  bool replan = false;      ///< Also ask for routes; needs a course with a goal.
};

struct ReplayedTrial {
  ReplayRecord record;
  std::vector<ActedTick> acted;  ///< One per tick.
};

/// What acts on the certificate of a robot, as live, replay and drive have it.
[[nodiscard]] ActionSetup actions_of(const Robot& robot,
                                     const ParameterSet& parameters,
                                     const SpeedLaw& law,
                                     const TrackingErrorTable& tracking_error);

/// One entry a law, in their order. Thread-safe. \throws std::invalid_argument if a law or a
/// parameter is out of range. \pre the trial is not rejected.
[[nodiscard]] std::vector<ReplayedTrial> replay_trial(const StudiedTrial& trial,
                                                      const BundleInfo& info,
                                                      const ParameterSet& parameters,
                                                      const ReplaySetup& setup);

}  // namespace tcert::study
