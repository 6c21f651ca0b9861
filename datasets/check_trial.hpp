#pragma once
/// \file
/// What one trial's log holds, before anything is computed from it.

#include <cstddef>
#include <optional>
#include <tcert/parameters.hpp>
#include <vector>

#include "datasets/trial_reader.hpp"

namespace tcert {

struct StreamCheck {
  std::size_t rows = 0;
  std::optional<double> median_rate_hz;  ///< Empty with fewer than two rows.
  double longest_gap_s = 0.0;
};

/// Empty members are not known: the trial was rejected, or the course has no such region.
struct TrialCheck {
  bool rejected = false;
  bool merged = false;  ///< The log is one ticks.csv: `pose` is its clock, the others are empty.
  StreamCheck pose;
  StreamCheck tactile;
  StreamCheck control;
  std::size_t ticks = 0;
  std::size_t stale_ticks = 0;
  std::size_t breaks = 0;
  std::optional<double> duration_s;  ///< From the first tick to the last.
  std::optional<double> distance_m;  ///< Sum of the steps of at least 1 cm.
  std::optional<bool> starts_in_start;
  std::optional<bool> ends_in_goal;
};

struct TrialCheckResult {
  TrialCheck check;
  std::vector<table::Diagnostic>
      diagnostics;  ///< Of the logs, and the warnings of check_values().
};

/// Reads and resamples the logs of one trial; `parameters` say what a contact is. Never throws on
/// bad content.
[[nodiscard]] TrialCheckResult check_trial(const Bundle& bundle,
                                           const TrialRow& trial,
                                           const ReadOptions& read = {},
                                           const ResampleOptions& grid = {},
                                           const CertificateParameters& parameters = {});

}  // namespace tcert
