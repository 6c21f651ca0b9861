#pragma once
/// \file
/// What was known of a run while it went on.

#include <cstdint>
#include <tcert/robot.hpp>
#include <witness/samples.hpp>

namespace tcert::witness {

/// Samples ready for F_t that were known at `time_ns`, of `felt`, from which no glitch was taken.
/// The last reading of each ray is left out: what it feels next may show that to be a glitch, and
/// what it would have proved comes with the next one. So every cell that is free at a time is free
/// at each later one, and a path that was found then proves at least as much.
/// O(samples x rays).
[[nodiscard]] Samples known_samples(const Samples& felt,
                                    std::int64_t time_ns,
                                    const Robot& robot,
                                    double lost_share);

}  // namespace tcert::witness
