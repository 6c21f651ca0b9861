#include <algorithm>
#include <cmath>
#include <tcert/guarded_drive.hpp>
#include <tcert/lengths.hpp>
#include <tcert/speed_gate.hpp>

namespace tcert::policies {
namespace {

/// A retreat ends after this many times what it should take, and a second.
constexpr double kPatience = 2.0;

}  // namespace

GuardedDrive::GuardedDrive(const PolicyParameters& parameters, double control_period_s) noexcept
    : parameters_(parameters), period_s_(control_period_s) {}

void GuardedDrive::reset() noexcept {
  phase_ = Phase::following;
  phase_s_ = 0.0;
  retreats_ = 0;
  replans_ = false;
}

void GuardedDrive::enter(Phase phase, Point position) noexcept {
  phase_ = phase;
  entered_ = position;
  phase_s_ = 0.0;
}

Command GuardedDrive::step(const Command& wanted,
                           const GuardedTick& guards,
                           const Pose& pose) noexcept {
  const Point here = pose.position;
  replans_ = false;
  phase_s_ += period_s_;
  if (phase_ == Phase::halting && reaches(phase_s_, parameters_.stop_s)) {
    enter(Phase::retreating, here);
  } else if (phase_ == Phase::retreating &&
             (distance(here, entered_) >= parameters_.reverse_m ||
              phase_s_ >= kPatience * parameters_.reverse_m / guards.retreat_speed_mps + 1.0)) {
    replans_ = true;
    ++retreats_;
    enter(Phase::creeping, here);
  } else if (phase_ == Phase::creeping && distance(here, halted_at_) > parameters_.clear_m) {
    phase_ = Phase::following;
  }
  if (phase_ == Phase::following && wanted.speed_mps > 0.0 && guards.halted()) {
    halted_at_ = here;
    enter(Phase::halting, here);
  }
  switch (phase_) {
    case Phase::halting:
      return {};
    case Phase::retreating:
      return {-guards.retreat_speed_mps, 0.0};
    case Phase::creeping:
    case Phase::following:
      break;
  }
  return at_granted_speed(wanted, guards.speed_mps, parameters_);
}

}  // namespace tcert::policies
