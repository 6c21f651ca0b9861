#pragma once
/// \file
/// Who is at risk when: the rows of a survival outcome as ranges of event times.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <statistics/survival/survival_outcome.hpp>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// Event times are numbered by stratum, then upwards; T of them. A row is at risk at the event
/// times first..last; most rows of a right-censored outcome start at their stratum's first one.
struct RiskSets {
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  std::vector<double> time;                  ///< T.
  std::vector<std::uint32_t> stratum_begin;  ///< Strata + 1: each one's first event time.
  std::vector<std::uint32_t> stratum_of;     ///< T.

  std::vector<std::uint32_t> first;  ///< n; kNever if the row is at risk at no event time.
  std::vector<std::uint32_t> last;   ///< n; likewise.

  /// The rows that are ever at risk, by `last`, at each the censored before the events.
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> begin;         ///< T + 1, into `order`.
  std::vector<std::uint32_t> events_begin;  ///< T, into `order`.

  /// Left truncation only: places in `order`, by `first`; rows that are at risk from their
  /// stratum's first event time on are left out.
  std::vector<std::uint32_t> late;
  std::vector<std::uint32_t> late_begin;  ///< T + 1, into `late`; empty if there are none.

  [[nodiscard]] std::size_t times() const noexcept { return time.size(); }
  [[nodiscard]] std::size_t strata() const noexcept { return stratum_begin.size() - 1; }
  [[nodiscard]] std::size_t events_at(std::size_t t) const noexcept {
    return begin[t + 1] - events_begin[t];
  }
};

/// `strata` may be null. \pre fewer than 2^32 - 1 rows. O(n log n).
[[nodiscard]] RiskSets risk_sets(const SurvivalOutcome& outcome, const table::Factor* strata);

}  // namespace tcert::statistics
