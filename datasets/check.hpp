#pragma once
/// \file
/// What a bundle holds, trial by trial, and everything that is wrong with it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/diagnostic.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

/// One stream of a trial. What cannot be said of fewer than two rows is missing.
struct StreamSummary {
  std::string name;  ///< "pose", "tactile", "control" or "ticks".
  std::size_t rows = 0;
  std::optional<double> rate_hz;  ///< 1 / median step of the clock.
  std::optional<double> longest_gap_s;
};

struct TrialSummary {
  std::string trial_id;
  bool rejected = false;  ///< Then nothing below is known.
  std::vector<StreamSummary> streams;
  std::size_t breaks = 0;   ///< Segments that start after the first.
  double duration_s = 0.0;  ///< From the first tick to the last.
  double distance_m = 0.0;  ///< Over fresh ticks, in steps of at least the dead band.
  std::size_t ticks = 0;
  std::size_t stale_ticks = 0;
  std::optional<bool> starts_in_start;  ///< Missing if the course has no S.
  std::optional<bool> ends_in_goal;     ///< Missing if the course has no G.
};

struct CheckOptions {
  ReadOptions read;
  ResampleOptions resample;
  double travel_deadband_m = 0.01;
};

struct BundleCheck {
  std::vector<Diagnostic> diagnostics;  ///< Of all trials, in their order.
  std::vector<TrialSummary> trials;     ///< One per trial, in file order.
};

/// Reads every trial. A first tick outside S is a warning: such a trial gets no certificate. One
/// trial is in memory at a time.
[[nodiscard]] BundleCheck check_bundle(const Bundle& bundle, const CheckOptions& options = {});

}  // namespace tcert
