#include <algorithm>
#include <cmath>
#include <tcert/elementary.hpp>
#include <tcert/lengths.hpp>
#include <tcert/mirror_exact.hpp>
#include <tcert/recovery.hpp>

namespace tcert::policies {
namespace {

BackOutLimits limits_of(const PolicyParameters& p, double min_turn_radius_m) noexcept {
  const double reverse_mps = std::min(p.reverse_mps, p.cruise_mps);
  return {p.stop_s,
          p.reverse_m,
          reverse_mps,
          p.reorient_rad,
          min_turn_radius_m > 0.0 ? std::min(p.max_yaw_rate_rps, reverse_mps / min_turn_radius_m)
                                  : p.max_yaw_rate_rps,
          min_turn_radius_m};
}

}  // namespace

Recovery::Recovery(const PolicyParameters& parameters,
                   double min_turn_radius_m,
                   double control_period_s) noexcept
    : parameters_(parameters),
      period_s_(control_period_s),
      front_cosine_(elementary::cos(parameters.front_rad)),
      back_out_(limits_of(parameters, min_turn_radius_m)) {}

void Recovery::reset() noexcept {
  back_out_.reset();
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
  int turn_side = freer_side;
  if (presses(pressure) && pressure.bump && sign_of(unit(pressure.bump->bearing_rad).y_m) != 0) {
    turn_side = -sign_of(unit(pressure.bump->bearing_rad).y_m);
  }
  if (place_) {
    ++failed_;
    gives_up_ = failed_ % parameters_.give_up_after == 0;
  } else {
    place_ = pose.position;
  }
  back_out_.begin(pose, turn_side);
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
  if (back_out_.is_over()) {
    hold_s_ = std::max(hold_s_ - period_s_, 0.0);
    if (stalls(pose.position, forward_mps) || presses(pressure)) {
      begin(pose, pressure, freer_side);
    }
  } else {
    const bool bumps_behind = pressure.bump && pressure.bump->force_n > parameters_.stop_force_n &&
                              unit(pressure.bump->bearing_rad).x_m < 0.0;
    back_out_.advance(pose, bumps_behind, period_s_);
    if (back_out_.is_over()) {
      hold_s_ = parameters_.hold_s;
      has_moved_from_ = false;
    }
  }
  return back_out_.is_over() ? std::nullopt : std::optional(back_out_.command());
}

std::optional<double> Recovery::held_turn(const Pose& pose) const noexcept {
  return hold_s_ > 0.0 ? std::optional(angle_between(pose.yaw_rad, back_out_.turned_to_rad())) : std::nullopt;
}

}  // namespace tcert::policies
