#pragma once
/// \file
/// What every policy does where it presses or gets nowhere: it backs out (section 8 of the paper).

#include <cstdint>
#include <optional>
#include <tcert/back_out.hpp>
#include <tcert/policy_parameters.hpp>
#include <tcert/senses.hpp>

namespace tcert::policies {

/// What presses in one step.
struct Pressure {
  double frontal_force_n = kMissing;  ///< Of a ray; NaN if none states one.
  std::optional<Bump> bump;           ///< Of the body.
};

/// The recoveries of one trial. One begins at a frontal force above F_stop, or where the robot was
/// driven forward for stall_pushed_m and moved less than stall_moved_m. It stands still, reverses,
/// turns to the freer side, on the spot or, if the robot has a turn radius, on that radius in
/// reverse, and has the new heading held for a while. It has failed if the next begins within
/// clear_m of where the first did.
///
/// Every member is noexcept and allocates nothing.
class Recovery {
 public:
  Recovery(const PolicyParameters& parameters,
           double min_turn_radius_m,
           double control_period_s) noexcept;

  void reset() noexcept;

  /// What to command while the robot recovers; none while it drives. `forward_mps` is the speed
  /// that the body was last told to drive, `freer_side` is +1 for left, -1 for right.
  std::optional<Command> step(const Pose& pose,
                              const Pressure& pressure,
                              int freer_side,
                              double forward_mps) noexcept;

  /// How far to turn for the heading that a recovery left; none if none is held.
  [[nodiscard]] std::optional<double> held_turn(const Pose& pose) const noexcept;

  /// Failed recoveries in a row.
  [[nodiscard]] std::uint32_t failed() const noexcept { return failed_; }

  /// In this step a recovery began after one more give_up_after of them had failed.
  [[nodiscard]] bool gives_up() const noexcept { return gives_up_; }

 private:
  [[nodiscard]] bool presses(const Pressure& pressure) const noexcept;
  [[nodiscard]] bool stalls(Point position, double forward_mps) noexcept;
  void begin(const Pose& pose, const Pressure& pressure, int freer_side) noexcept;

  PolicyParameters parameters_;
  double period_s_;
  double front_cosine_;

  BackOut back_out_;
  double hold_s_ = 0.0;         // how long it is still held
  std::optional<Point> place_;  // where the first of a row of recoveries began
  std::uint32_t failed_ = 0;
  bool gives_up_ = false;
  Point moved_from_;  // progress is counted from here
  bool has_moved_from_ = false;
  double pushed_m_ = 0.0;
};

}  // namespace tcert::policies
