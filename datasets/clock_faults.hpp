#pragma once
/// \file
/// Where the times of a stream do not rise, and of which kind each place is.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert {

/// What the time of a counter of 32 bits falls by when it begins anew.
inline constexpr std::int64_t kWrapOfMs = (std::int64_t{1} << 32U) * 1'000'000;
inline constexpr std::int64_t kWrapOfUs = (std::int64_t{1} << 32U) * 1'000;

/// The clock was set back: rows from here on are a stretch of their own.
struct ClockStep {
  std::size_t row = 0;        ///< The first of the later stretch.
  std::int64_t last_ns = 0;   ///< Latest time of the stretch before.
  std::int64_t first_ns = 0;  ///< Time of `row`.
  std::int64_t wrap_ns = 0;   ///< kWrapOfMs or kWrapOfUs if that is what happened; else 0.

  [[nodiscard]] std::int64_t back_ns() const noexcept { return last_ns - first_ns; }
};

struct ClockFaults {
  bool any = false;  ///< Some time is not after the one before it.
  std::vector<ClockStep> steps;
  std::size_t late_rows = 0;   ///< Before the latest time of their stretch, by less than the gap.
  std::size_t first_late = 0;  ///< The first of them.
  std::int64_t latest_ns = 0;  ///< The most that one is late by.
  std::int64_t last_ns = 0;    ///< Latest time of the last stretch.
  bool is_without_order = false;  ///< So many steps that these are no stretches of a clock.
};

/// Rows that are late by less than `max_gap_ns` are packets out of order; a row that is late by
/// more begins a new stretch. O(rows).
[[nodiscard]] ClockFaults find_clock_faults(std::span<const std::int64_t> time_ns,
                                            std::int64_t max_gap_ns);

/// Median of the steps that rise, 0 without one. O(rows).
[[nodiscard]] std::int64_t median_step_ns(std::span<const std::int64_t> time_ns);

}  // namespace tcert
