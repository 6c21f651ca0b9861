#pragma once
/// \file
/// Whether the streams of a trial have times in common, and where they begin and end apart.
/// Internal to trial_reader.cpp.

#include "datasets/bundle.hpp"
#include "datasets/stream_reader.hpp"

namespace tcert {

/// Streams without a common instant are an error; begins and ends further apart than max_gap_s are
/// warnings. \pre both are in order of time.
void compare_streams(const Stream& pose,
                     const Stream& tactile,
                     const BundleInfo& info,
                     StreamReader& reader);

/// False, with a warning, if the commands lie before or after all poses by more than the gap: they
/// are then of another clock, and nobody knows when they were given.
[[nodiscard]] bool shares_clock(const Stream& control,
                                const Stream& pose,
                                double max_gap_s,
                                StreamReader& reader);

}  // namespace tcert
