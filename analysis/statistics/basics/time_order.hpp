#pragma once
/// \file
/// Rows in the order of time within groups: what every risk-set estimator walks through.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

namespace tcert::statistics {

/// Rows by group, then by time.
struct TimeOrder {
  /// Ascending in stop; at equal stops the events come before the censored, as they happen before
  /// them by convention.
  std::vector<std::uint32_t> by_stop;
  std::vector<std::uint32_t> by_start;  ///< Ascending in start; empty if not left-truncated.
  std::vector<std::size_t> first;       ///< Group g is [first[g], first[g + 1]) of both.

  [[nodiscard]] std::size_t groups() const noexcept { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> stops_of(std::size_t group) const;
  [[nodiscard]] std::span<const std::uint32_t> starts_of(std::size_t group) const;
};

/// `group` holds a code below `groups` per row, or is empty for a single group. O(n log n).
/// \throws std::invalid_argument if lengths differ, a code is out of range, a time is not finite,
/// an event is neither 0 nor 1, or a start is not before its stop.
[[nodiscard]] TimeOrder time_order(const SurvivalOutcome& outcome,
                                   std::span<const std::uint32_t> group = {},
                                   std::size_t groups = 1);

/// Stable counting sort of `order` by the group of the rows it names; `first` as in TimeOrder.
[[nodiscard]] std::vector<std::uint32_t> group_order(std::vector<std::uint32_t> order,
                                                     std::span<const std::uint32_t> group,
                                                     std::span<const std::size_t> first);

}  // namespace tcert::statistics
