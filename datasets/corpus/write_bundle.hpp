#pragma once
/// \file
/// Simulated trials as a bundle on disk.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/corpus/simulated_trial.hpp"

namespace tcert {

/// Called after each trial that is written, one call at a time, from any thread.
using TrialProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// A bundle of trials 0 ... trials - 1 of `simulate`.
struct SimulatedBundle {
  BundleInfo info;
  std::vector<std::string> extra_columns;
  std::uint64_t trials = 0;
  std::function<SimulatedTrial(std::uint64_t)> simulate;  ///< Called from several threads at once.
};

/// Writes bundle.json, trials.csv, logs/ and worlds/; every CSV begins with a comment
/// "# synthetic, seed N". The folder appears whole or not at all; it must not hold anything yet
/// unless `replace`. Trials are made and written in parallel under the caller's limit on TBB's
/// threads; the bytes do not depend on it. Memory: one trial a thread, one row a trial.
/// \throws WriteError, and what `simulate` throws.
void write_simulated_bundle(const std::filesystem::path& folder,
                            const SimulatedBundle& bundle,
                            const TrialProgress& progress,
                            bool replace);

}  // namespace tcert
