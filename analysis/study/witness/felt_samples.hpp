#pragma once
/// \file
/// A trial's log as the samples of a witness.

#include <tcert/robot.hpp>
#include <witness/samples.hpp>

#include "datasets/trial_reader.hpp"

namespace tcert::study {

/// Where the rays were felt, at the rate of the tactile stream, raw, with the poses of the pose
/// stream; of a merged log its ticks that are not stale. Breaks of the clock and of the segments
/// are breaks. Glitches are not taken out.
[[nodiscard]] witness::Samples felt_samples(const TrialLog& log,
                                            const Robot& robot,
                                            double pose_bridge_s);

/// The same of ticks alone.
[[nodiscard]] witness::Samples felt_samples(const TickTable& ticks, const Robot& robot);

}  // namespace tcert::study
