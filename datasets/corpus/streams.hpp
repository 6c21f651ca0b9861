#pragma once
/// \file
/// What the robot logs of a drive: three streams, each on its own jittered clock.

#include <cstdint>
#include <table/random.hpp>
#include <vector>

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

inline constexpr double kTactileRate = 83.0;  ///< Hz, native.
inline constexpr double kPoseRate = 20.0;     ///< Hz.

/// Sample times of one stream from 0 to `end_s`, in ns: jittered by a tenth of the period, one
/// sample in 1,000 lost, at native rates with a silence now and then. The clock has draws of its
/// own, so that what is logged at an instant does not depend on how long the log is.
[[nodiscard]] std::vector<std::int64_t> sample_times(double rate_hz,
                                                     double end_s,
                                                     bool native_rates,
                                                     table::RandomStream& random);

/// What odometry says of a pose: white noise of 0.8 mm and 0.002 rad, one standard deviation.
/// `side` is 1, or -1 for the noise seen in a mirror along the x axis; `scale` is that of the
/// noise.
[[nodiscard]] Pose odometry(const Pose& pose,
                            double side,
                            table::RandomStream& random,
                            double scale = 1.0) noexcept;

/// Laplace about the median: short most of the time, with the odd late loop.
[[nodiscard]] double draw_latency_ms(double median_ms,
                                     double scale_ms,
                                     table::RandomStream& random) noexcept;

/// Times are whole multiples of 0.1 ms; positions and bends of 1e-4, commanded speeds and forces
/// of 1e-3 and 1e-2, so that what is written with that many decimals reads back as the same number.
/// Pose noise is white, 0.8 mm and 0.002 rad (one standard deviation): odometry without drift.
[[nodiscard]] TrialLog log_drive(const Drive& drive,
                                 const WallIndex& walls,
                                 const StreamOptions& options);

}  // namespace tcert
