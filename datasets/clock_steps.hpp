#pragma once
/// \file
/// Steps of a clock that all streams of a trial share: by how much what lies after each is later
/// than it says.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "datasets/clock_faults.hpp"

namespace tcert {

/// What is wrong with the times of one stream, and how dense they are.
struct StreamSteps {
  const ClockFaults* faults = nullptr;  ///< Never null.
  std::int64_t median_step_ns = 0;
};

/// For each step the nanoseconds that the rows after it, up to the next step, are to be set ahead,
/// the same for all streams, so that poses and touches of one instant stay at one instant. A
/// counter that began anew goes on counting. Of another step nobody knows how long it took: the
/// later stretch begins one median step of its stream after the earlier one, in the stream where
/// that is latest.
///
/// Nothing if the streams do not step alike: as often, at the same instant and by as much, each to
/// within `max_gap_ns`, or if times would leave their range. \pre at least one stream.
[[nodiscard]] std::optional<std::vector<std::int64_t>> shifts_after_steps(
    std::span<const StreamSteps> streams, std::int64_t max_gap_ns);

}  // namespace tcert
