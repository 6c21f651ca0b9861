#pragma once
/// \file
/// A driven trial from its design to its row and log.

#include <span>
#include <string>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/corpus/simulated_trial.hpp"
#include "datasets/driven/driven_run.hpp"

namespace tcert {

struct DrivenTrial {
  SimulatedTrial trial;  ///< Row with the extra columns below, log and world, as a bundle has them.
  DrivenEvents events;
};

/// A column that a driven trial's row has beyond those of every bundle: an outcome of the drive or
/// a fact of its world, never a predictor.
struct DrivenColumn {
  const char* name;
  const char* unit;  ///< Empty for a pure number or a word.
  const char* doc;   ///< One line, no full stop.
};
[[nodiscard]] std::span<const DrivenColumn> driven_columns() noexcept;

/// Their names.
[[nodiscard]] std::vector<std::string> driven_extra_columns();

/// What has happened so far; of a trial that has not ended the row has no outcome. O(log).
[[nodiscard]] DrivenTrial trial_of(const DrivenRun& run);

/// Drives one trial: `Command controller(const Senses&)` is called at each control step. The same
/// design and the same commands give the same bytes.
/// \throws what DrivenRun and the controller throw.
template <class Controller>
[[nodiscard]] DrivenTrial drive_trial(const DrivenDesign& design, Controller&& controller) {
  DrivenRun run(design);
  while (const policies::Senses* senses = run.next()) {
    run.take(controller(*senses));
  }
  return trial_of(run);
}

/// Description of a bundle of driven trials: robot, S and G of the figure-8, lighting tiers, trial
/// limit, provenance. `native_rates` as in the designs.
[[nodiscard]] BundleInfo driven_info(std::uint64_t seed,
                                     const DriveParameters& parameters,
                                     bool native_rates);

}  // namespace tcert
