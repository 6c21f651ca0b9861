#pragma once
/// \file
/// How regular a clock is: its steps in order of size.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tcert {

/// The increasing steps of a clock, in seconds.
struct ClockSteps {
  double shortest_s = 0.0;
  double p05_s = 0.0;  ///< 5 % of the steps are at most this long; an observed step.
  double median_s = 0.0;
  double p95_s = 0.0;
  double longest_s = 0.0;
  std::size_t not_increasing = 0;  ///< Steps of zero or back, not among the others.
};

/// Empty if no step increases. O(n log n).
[[nodiscard]] std::optional<ClockSteps> clock_steps(std::span<const std::int64_t> time_ns);

}  // namespace tcert
