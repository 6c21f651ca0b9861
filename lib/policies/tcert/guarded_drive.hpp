#pragma once
/// \file
/// A policy's command under the guards: their halts and retreats as commands.

#include <cstdint>
#include <tcert/guards.hpp>
#include <tcert/policy_parameters.hpp>
#include <tcert/senses.hpp>

namespace tcert::policies {

/// One run under guards. Forward commands run at the speed that the guards grant. Where they halt,
/// the robot stands still for recovery_stop_s and retreats recovery_reverse_m straight back at
/// retreat_speed_mps. What made them halt (V_rob after a tight edge) does not come back by that, so
/// it may then go on at creep_mps until it is recovery_clear_m away from where it was halted; with
/// creep_mps = 0 it stands. Reversing is never refused: a policy's own recovery goes on.
///
/// Every member is noexcept and allocates nothing.
class GuardedDrive {
 public:
  GuardedDrive(const PolicyParameters& parameters, double control_period_s) noexcept;

  void reset() noexcept;

  /// `guards` is what they say of the last tick, `pose` that of this step.
  Command step(const Command& wanted, const GuardedTick& guards, const Pose& pose) noexcept;

  /// In this step a retreat ended. G3 replans then: what drives may give the lane up
  /// (Policy::give_up_lane).
  [[nodiscard]] bool replans() const noexcept { return replans_; }
  [[nodiscard]] std::uint32_t retreats() const noexcept { return retreats_; }

 private:
  enum class Phase : std::uint8_t { following, halting, retreating, creeping };

  void enter(Phase phase, Point position) noexcept;

  PolicyParameters parameters_;
  double period_s_;
  Phase phase_ = Phase::following;
  Point entered_;
  double phase_s_ = 0.0;
  Point halted_at_;
  std::uint32_t retreats_ = 0;
  bool replans_ = false;
};

}  // namespace tcert::policies
