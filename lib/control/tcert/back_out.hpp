#pragma once
/// \file
/// Stop, reverse, re-orient (section 8 of the paper): how a robot backs out of where it is.

#include <cstdint>
#include <optional>
#include <tcert/command.hpp>
#include <tcert/geometry.hpp>

namespace tcert {

struct BackOutLimits {
  double stop_s = 0.3;
  double reverse_m = 0.15;
  double reverse_mps = 0.1;  ///< > 0.
  double reorient_rad = 0.5;
  double turn_rate_rps = 0.6;  ///< > 0.
  /// 0 turns on the spot; else the robot turns in reverse, which must be on its radius.
  double min_turn_radius_m = 0.0;
};

/// One manoeuvre: the robot stands still for stop_s, reverses by reverse_m and turns by
/// reorient_rad to one side. A phase of motion ends after twice what it should take and a second,
/// too, for behind there may be something as well, and reversing ends at once where the body bumps
/// behind. noexcept, allocates nothing.
class BackOut {
 public:
  enum class Phase : std::uint8_t { none, stopping, reversing, turning };

  explicit BackOut(const BackOutLimits& limits) noexcept;

  void reset() noexcept { phase_ = Phase::none; }

  /// `side`: +1 turns to the left, -1 to the right.
  void begin(const Pose& pose, int side) noexcept;

  /// The next `seconds` have passed. \pre it has begun and not ended.
  void advance(const Pose& pose, bool bumps_behind, double seconds) noexcept;

  [[nodiscard]] Phase phase() const noexcept { return phase_; }
  [[nodiscard]] bool is_over() const noexcept { return phase_ == Phase::none; }
  /// What to command in this phase.
  [[nodiscard]] Command command() const noexcept;
  /// The yaw that the turn was to end at. \pre it has begun to turn.
  [[nodiscard]] double turned_to_rad() const noexcept { return turned_to_rad_; }

 private:
  void enter(Phase phase, const Pose& pose) noexcept;

  BackOutLimits limits_;
  Phase phase_ = Phase::none;
  Pose entered_;          // where the phase began
  double phase_s_ = 0.0;  // since then
  int side_ = 0;
  double turned_to_rad_ = 0.0;
};

}  // namespace tcert
