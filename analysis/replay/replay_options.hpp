#pragma once
/// \file
/// Parameters of a replay.

namespace tcert {

struct ReplayOptions {
  double slow_speed_mps = 0.02;  ///< Slower is standing still: it keeps its time; > 0.
  double slow_window_s = 0.5;    ///< Trailing time over which that speed is measured; >= 0.001.
  double stall_m = 0.05;         ///< Path without forward speed that makes a stall; > 0.
};

/// \throws std::invalid_argument naming the option and the range it must lie in.
void validate(const ReplayOptions& options);

}  // namespace tcert
