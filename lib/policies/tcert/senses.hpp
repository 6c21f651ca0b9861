#pragma once
/// \file
/// What a policy is given at each control step, and what it commands.

#include <cstdint>
#include <optional>
#include <span>
#include <tcert/command.hpp>
#include <tcert/geometry.hpp>
#include <tcert/tick.hpp>

namespace tcert::policies {

/// A contact of the body itself, as a bumper ring feels it.
struct Bump {
  double bearing_rad = 0.0;  ///< From the heading, counter-clockwise.
  double force_n = 0.0;
};

/// An obstacle that a camera saw in one direction of its fan.
struct Sighting {
  double bearing_rad = 0.0;  ///< From the heading, counter-clockwise.
  double range_m = 0.0;      ///< To the obstacle, from the body's centre.
};

/// One control step. Nothing of the world: what the robot felt, where its odometry puts it, and
/// where G is from there.
struct Senses {
  Tick tick;                         ///< Readings as logged; its pose is odometry.
  double travel_m = 0.0;             ///< Distance driven so far, by odometry; never falls.
  double speed_mps = 0.0;            ///< Along the heading, measured; negative in reverse.
  Point goal;                        ///< Middle of G in the frame of the odometry.
  std::optional<Bump> bump;          ///< The hardest, if the body touches.
  std::span<const Sighting> camera;  ///< Empty without a camera.
  /// Speed that the body was last told to drive, after speed laws and guards; NaN: what the policy
  /// itself commanded. A robot that a law halts is not stuck.
  double commanded_mps = kMissing;
};

using tcert::Command;

}  // namespace tcert::policies
