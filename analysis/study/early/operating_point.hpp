#pragma once
/// \file
/// A threshold on TC_early that stops a trial early, and what it costs.

#include <cstddef>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <vector>

#include "analysis/study/early/early_trials.hpp"

namespace tcert::study {

struct OperatingShare {
  double value = 0.0;
  std::optional<statistics::Interval> interval;  ///< 95 %.
};

/// Trials with a TC_early below `threshold_m` are stopped.
struct OperatingPoint {
  double threshold_m = 0.0;
  std::optional<statistics::Interval> threshold_interval;
  std::size_t successes = 0;
  std::size_t failures = 0;
  OperatingShare kept;     ///< Of the successes: at least the retention that was asked for.
  OperatingShare stopped;  ///< Of the failures.
  /// Intervals resample whole days: of the threshold and of what it stops it is chosen anew in each
  /// resample, and of what it keeps it is the one above. Else they are Wilson's at that threshold,
  /// and the threshold has none.
  bool by_days = false;
};

/// The largest threshold that keeps `retention` of the successes: the value of a success. Whole
/// days are resampled 2,000 times by seed 1, expanded percentiles, unless there are too_few() of
/// them or of an outcome. Empty without a success or a failure. \throws std::invalid_argument
/// unless 0 < retention <= 1.
[[nodiscard]] std::optional<OperatingPoint> operating_point(const EarlyTrials& trials,
                                                            double retention = 0.95);

struct OperatingCurvePoint {
  double threshold_m = 0.0;
  double kept = 0.0;
  double stopped = 0.0;
};

/// Both shares at `points` even thresholds, from the least value to the largest.
/// \pre both outcomes occur, and points > 1.
[[nodiscard]] std::vector<OperatingCurvePoint> operating_curve(const EarlyTrials& trials,
                                                               std::size_t points);

}  // namespace tcert::study
