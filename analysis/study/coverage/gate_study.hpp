#pragma once
// How often the sets of the 50 % point cover its large-sample value, over simulated micro-studies.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/study/watch.hpp"

namespace tcert::study::coverage {

struct GateOptions {
  std::size_t studies = 1000;  ///< Each one is `simulate --micro-study` of its own seed.
  std::size_t replicates = 999;
  std::uint64_t first_seed = 1;
  double level = 0.95;
};

struct GateCoverage {
  std::string method;
  std::size_t sets = 0;  ///< Studies that have one; the others are separated.
  std::size_t unbounded = 0;
  double covered = 0.0;  ///< Share of the sets that cover the large-sample point.
  double monte_carlo_se = 0.0;
  double covered_zero = 0.0;    ///< Share that cover margin 0.
  double median_width_m = 0.0;  ///< Of the bounded ones.
};

struct GateSummary {
  double point_m = 0.0;        ///< Of all passes of all studies together: the large sample.
  double point_error_m = 0.0;  ///< Its standard error.
  double slope_per_m = 0.0;
  double mean_estimate_m = 0.0;
  double median_estimate_m = 0.0;
  std::size_t separated = 0;
  std::vector<GateCoverage> methods;
};

/// Passes are simulated, resampled to ticks and certified as the tool does. The same numbers for
/// any number of threads. `watch` hears of each study that is made, and of each that is evaluated.
GateSummary run_gates(const GateOptions& options, const Watch& watch = {});

}  // namespace tcert::study::coverage
