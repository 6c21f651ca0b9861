#include <algorithm>
#include <cmath>
#include <tcert/elementary.hpp>
#include <tcert/lengths.hpp>
#include <tcert/mirror_exact.hpp>
#include <tcert/recovery.hpp>

namespace tcert::policies {
namespace {

/// A phase of motion ends after this many times what it should take, and a second: behind there may
/// be something too.
constexpr double kPatience = 2.0;

}  // namespace

Recovery::Recovery(const PolicyParameters& parameters,
                   double min_turn_radius_m,
                   double control_period_s) noexcept
    : parameters_(parameters),
      min_turn_radius_m_(min_turn_radius_m),
      period_s_(control_period_s),
      front_cosine_(elementary::cos(parameters.front_rad)),
      reverse_mps_(std::min(parameters.reverse_mps, parameters.cruise_mps)),
      turn_rate_rps_(min_turn_radius_m > 0.0
                         ? std::min(parameters.max_yaw_rate_rps, reverse_mps_ / min_turn_radius_m)
                         : parameters.max_yaw_rate_rps) {}

void Recovery::reset() noexcept {
  phase_ = Phase::driving;
  hold_s_ = 0.0;
  place_.reset();
  failed_ = 0;
  gives_up_ = false;
  has_moved_from_ = false;
  pushed_m_ = 0.0;
}

bool Recovery::presses(const Pressure& pressure) const noexcept {
  const double stop_n = parameters_.stop_force_n;
  return pressure.frontal_force_n > stop_n ||
         (pressure.bump && pressure.bump->force_n > stop_n &&
          unit(pressure.bump->bearing_rad).x_m >= front_cosine_);
}

// The way that was commanded since the robot last made progress. The command counts and not the
// time, so that a robot that a law lets creep, or halts, is not taken for one that is stuck.
bool Recovery::stalls(Point position, double forward_mps) noexcept {
  if (!has_moved_from_ || distance(position, moved_from_) >= parameters_.stall_moved_m) {
    moved_from_ = position;
    has_moved_from_ = true;
    pushed_m_ = 0.0;
  }
  pushed_m_ += std::max(forward_mps, 0.0) * period_s_;
  return pushed_m_ >= parameters_.stall_pushed_m;
}

void Recovery::begin(const Pose& pose, const Pressure& pressure, int freer_side) noexcept {
  turn_side_ = freer_side;
  if (presses(pressure) && pressure.bump && sign_of(unit(pressure.bump->bearing_rad).y_m) != 0) {
    turn_side_ = -sign_of(unit(pressure.bump->bearing_rad).y_m);
  }
  if (place_) {
    ++failed_;
    gives_up_ = failed_ % parameters_.give_up_after == 0;
  } else {
    place_ = pose.position;
  }
  enter(Phase::stopping, pose);
}

void Recovery::enter(Phase phase, const Pose& pose) noexcept {
  phase_ = phase;
  entered_ = pose;
  phase_s_ = 0.0;
}

void Recovery::leave_phase(const Pose& pose, const Pressure& pressure) noexcept {
  const bool bumps_behind = pressure.bump && pressure.bump->force_n > parameters_.stop_force_n &&
                            unit(pressure.bump->bearing_rad).x_m < 0.0;
  const auto lasts = [&](double expected_s) { return phase_s_ >= kPatience * expected_s + 1.0; };
  if (phase_ == Phase::stopping && reaches(phase_s_, parameters_.stop_s)) {
    enter(Phase::reversing, pose);
  }
  if (phase_ == Phase::reversing &&
      (distance(pose.position, entered_.position) >= parameters_.reverse_m || bumps_behind ||
       lasts(parameters_.reverse_m / reverse_mps_))) {
    enter(Phase::turning, pose);
    held_rad_ = pose.yaw_rad + turn_side_ * parameters_.reorient_rad;
  } else if (phase_ == Phase::turning &&
             (std::abs(angle_between(entered_.yaw_rad, pose.yaw_rad)) >= parameters_.reorient_rad ||
              (bumps_behind && min_turn_radius_m_ > 0.0) ||
              lasts(parameters_.reorient_rad / turn_rate_rps_))) {
    phase_ = Phase::driving;
    hold_s_ = parameters_.hold_s;
    has_moved_from_ = false;
  }
}

Command Recovery::command() const noexcept {
  switch (phase_) {
    case Phase::reversing:
      return {-reverse_mps_, 0.0};
    case Phase::turning:
      return {min_turn_radius_m_ > 0.0 ? -reverse_mps_ : 0.0, turn_side_ * turn_rate_rps_};
    case Phase::driving:
    case Phase::stopping:
      break;
  }
  return {};
}

std::optional<Command> Recovery::step(const Pose& pose,
                                      const Pressure& pressure,
                                      int freer_side,
                                      double forward_mps) noexcept {
  gives_up_ = false;
  if (place_ && distance(pose.position, *place_) > parameters_.clear_m) {
    place_.reset();
    failed_ = 0;
  }
  if (phase_ == Phase::driving) {
    hold_s_ = std::max(hold_s_ - period_s_, 0.0);
    if (stalls(pose.position, forward_mps) || presses(pressure)) {
      begin(pose, pressure, freer_side);
    }
  } else {
    phase_s_ += period_s_;
    leave_phase(pose, pressure);
  }
  return phase_ == Phase::driving ? std::nullopt : std::optional(command());
}

std::optional<double> Recovery::held_turn(const Pose& pose) const noexcept {
  return hold_s_ > 0.0 ? std::optional(angle_between(pose.yaw_rad, held_rad_)) : std::nullopt;
}

}  // namespace tcert::policies
