#pragma once
/// \file
/// What the robot logs of a drive: three streams, each on its own jittered clock.

#include "datasets/corpus/drive.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

struct StreamOptions {
  std::uint64_t seed = 1;
  std::uint64_t index = 0;
  bool native_rates = false;  ///< Tactile 83, control 50, pose 20 Hz; otherwise 20 Hz each.
  double calibration_bias_m = 0.0;
};

/// Where the drive is at a time: between two of its steps on the straight between them.
[[nodiscard]] Pose pose_at(const Drive& drive, std::int64_t time_ns) noexcept;

/// Times are whole multiples of 0.1 ms; positions and bends of 1e-4, commanded speeds and forces
/// of 1e-3 and 1e-2, so that what is written with that many decimals reads back as the same number.
/// Pose noise is white, 0.8 mm and 0.002 rad (one standard deviation): odometry without drift.
[[nodiscard]] TrialLog log_drive(const Drive& drive,
                                 const WallIndex& walls,
                                 const StreamOptions& options);

}  // namespace tcert
