#pragma once
/// \file
/// One trial of the synthetic corpus, as a pure function of its design.

#include <string>
#include <utility>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/corpus/design.hpp"
#include "datasets/trial_reader.hpp"
#include "datasets/world.hpp"

namespace tcert {

struct SimulatedTrial {
  TrialRow row;  ///< One extra cell: true_margin_m.
  TrialLog log;
  World world;
  /// Files beside the streams in the trial's folder, by name.
  std::vector<std::pair<std::string, std::string>> more_logs{};
  bool owns_world = true;  ///< False if another trial of the bundle writes the same world's file.
  double true_margin_m = 0.0;  ///< Least gate width on the route driven, less the body width.
};

/// Names of the columns that a simulated trial's row has beyond those of every bundle.
[[nodiscard]] std::vector<std::string> corpus_extra_columns();

/// The same design gives the same trial, bit for bit, on any thread of any machine with the same
/// arithmetic. About 2 ms.
/// \throws std::logic_error if the drive ends otherwise than designed.
[[nodiscard]] SimulatedTrial simulate_trial(const TrialDesign& design);

}  // namespace tcert
