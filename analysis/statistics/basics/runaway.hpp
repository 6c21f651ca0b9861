#pragma once
/// \file
/// When an estimate of a log ratio is finite in name only, because a few rows overlap by a hair.

#include <vector>

namespace tcert::statistics {

/// A spread that neither an outlier nor a rare level moves. Of two values, as of a dummy, their
/// distance. Of more, the interquartile range over 1.349 (the standard deviation of a normal
/// sample); where that is 0, the median distance from the median of the values that differ from it.
/// 0 for a constant. Never above the range of the values. O(n).
[[nodiscard]] double typical_spread(std::vector<double> values);

/// Log odds at which a probability is numerically 0 or 1: 10 machine epsilons, as R's `glm` warns.
inline constexpr double kCertainLogRatio = 34.0;

/// Largest standard error: an interval of 17 powers of ten.
inline constexpr double kLargestLogError = 10.0;

/// Of a log ratio, all per typical spread of its column.
struct SpreadRatio {
  double log_ratio = 0.0;
  double error = 0.0;                 ///< Standard error.
  double error_without_effect = 0.0;  ///< What it would be at even odds, or equal hazards.
};

/// Whether a log ratio has run away. Either it is above kCertainLogRatio, so that one spread takes
/// an even chance to certainty, and above 5 of the errors that the column would have without any
/// effect; or its error is above kLargestLogError and its curvature less than that of one of the
/// `trials` (or events) without effect. So a collinear or badly scaled column, whose error is large
/// without any effect, is not meant.
[[nodiscard]] bool has_run_away(const SpreadRatio& ratio, double trials) noexcept;

/// Whether one could have run away whose ratio and error are per range of its column, which no
/// spread exceeds: what needs no spread to be ruled out.
[[nodiscard]] bool may_have_run_away(const SpreadRatio& ratio_of_range) noexcept;

}  // namespace tcert::statistics
