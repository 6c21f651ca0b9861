#pragma once
/// \file
/// Failed trials kept at risk until the trial limit.

#include <cstdint>
#include <span>
#include <statistics/survival/survival_outcome.hpp>

namespace tcert::statistics {

/// A robot that has failed will never reach the exit: to censor it when it fails assumes that it
/// might have, as often as those that still run. Here it stays at risk, without event, until
/// `limit`, the time at which trials are ended. If the limit is the only other reason for
/// censoring, these are the risk sets of Fine & Gray (1999) for the subdistribution hazard.
///
/// `failure` holds 1 where the trial failed. A failed row stops at `limit`, or when it did if that
/// was later, with event 0; all others are as they were.
/// \throws std::invalid_argument if lengths differ, `limit` is not finite, a failed row has an
/// event or `failure` holds another number than 0 and 1.
[[nodiscard]] SurvivalOutcome failures_at_limit(const SurvivalOutcome& outcome,
                                                std::span<const std::uint8_t> failure,
                                                double limit);

}  // namespace tcert::statistics
