#pragma once
/// \file
/// When an estimate of a log ratio is finite in name only, because a few rows overlap by a hair.

#include <vector>

namespace tcert {

/// A spread that neither an outlier nor a rare level moves: the interquartile range over 1.349 (the
/// standard deviation of a normal sample); where that is 0, the median distance from the median of
/// the values that differ from it, which is 1 for a dummy. 0 for a constant. O(n log n).
[[nodiscard]] double typical_spread(std::vector<double> values);

/// Log odds at which a probability is numerically 0 or 1: 10 machine epsilons, as R's `glm` warns.
inline constexpr double kCertainLogRatio = 34.0;

/// Largest standard error: an interval of 17 powers of ten.
inline constexpr double kLargestLogError = 10.0;

/// Whether a log ratio has run away, both numbers per typical spread of its column: it is above
/// kCertainLogRatio, or its error is above kLargestLogError without a `curved` likelihood: one
/// whose curvature along it is at least that of an average single trial (or event) without effect.
/// So a collinear or badly scaled column, whose curvature is small anywhere, is not meant.
[[nodiscard]] bool has_run_away(double log_ratio, double error, bool curved) noexcept;

}  // namespace tcert
