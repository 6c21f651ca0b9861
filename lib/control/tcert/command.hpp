#pragma once
/// \file
/// What a body is told to do.

namespace tcert {

/// Of the body, as a differential drive takes it.
struct Command {
  double speed_mps = 0.0;     ///< Along the heading; negative in reverse.
  double yaw_rate_rps = 0.0;  ///< Counter-clockwise.
};

}  // namespace tcert
