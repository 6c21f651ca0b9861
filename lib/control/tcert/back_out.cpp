#include <cmath>
#include <tcert/back_out.hpp>
#include <tcert/lengths.hpp>

namespace tcert {
namespace {

/// A phase of motion ends after this many times what it should take, and a second.
constexpr double kPatience = 2.0;

}  // namespace

BackOut::BackOut(const BackOutLimits& limits) noexcept : limits_(limits) {}

void BackOut::enter(Phase phase, const Pose& pose) noexcept {
  phase_ = phase;
  entered_ = pose;
  phase_s_ = 0.0;
}

void BackOut::begin(const Pose& pose, int side) noexcept {
  side_ = side;
  enter(Phase::stopping, pose);
}

void BackOut::advance(const Pose& pose, bool bumps_behind, double seconds) noexcept {
  phase_s_ += seconds;
  const auto lasts = [&](double expected_s) { return phase_s_ >= kPatience * expected_s + 1.0; };
  if (phase_ == Phase::stopping && reaches(phase_s_, limits_.stop_s)) {
    enter(Phase::reversing, pose);
  }
  if (phase_ == Phase::reversing &&
      (distance(pose.position, entered_.position) >= limits_.reverse_m || bumps_behind ||
       lasts(limits_.reverse_m / limits_.reverse_mps))) {
    enter(Phase::turning, pose);
    turned_to_rad_ = pose.yaw_rad + side_ * limits_.reorient_rad;
  } else if (phase_ == Phase::turning &&
             (std::abs(angle_between(entered_.yaw_rad, pose.yaw_rad)) >= limits_.reorient_rad ||
              (bumps_behind && limits_.min_turn_radius_m > 0.0) ||
              lasts(limits_.reorient_rad / limits_.turn_rate_rps))) {
    phase_ = Phase::none;
  }
}

Command BackOut::command() const noexcept {
  switch (phase_) {
    case Phase::reversing:
      return {-limits_.reverse_mps, 0.0};
    case Phase::turning:
      return {limits_.min_turn_radius_m > 0.0 ? -limits_.reverse_mps : 0.0,
              side_ * limits_.turn_rate_rps};
    case Phase::none:
    case Phase::stopping:
      break;
  }
  return {};
}

}  // namespace tcert
