#pragma once
/// \file
/// What drives a trial in closed loop: a policy and, where its speed is gated or its ticks are
/// monitored, the runtime of the live loop.

#include <optional>
#include <tcert/guarded_drive.hpp>
#include <tcert/policy.hpp>
#include <tcert/runtime.hpp>
#include <tcert/senses.hpp>
#include <vector>

#include "analysis/study/driven/arm.hpp"
#include "analysis/study/trials/parameters.hpp"
#include "datasets/driven/driven_world.hpp"

namespace tcert::study {

/// The parameters of an arm's policy: those of the set, of which cruise and caution are the
/// policy's fitted ones unless they are set, and risk_weight is 0 without memory.
[[nodiscard]] policies::PolicyParameters parameters_of(const Arm& arm,
                                                       const ParameterSet& parameters);

/// Drives one trial. At each control step the policy commands; every tick_s the runtime takes the
/// tick of that step, as the live loop does, and its guards say what speed the law grants. The
/// barrier law filters the command of every control step, and an alarm of the rules backs the robot
/// out of where it is. Without a law and rules the policy's command stands.
///
/// A law that halts for want of margin would halt for good, for what it goes by changes with travel
/// alone: in the loop it leaves at least creep_mps, where 0 is the law as printed.
///
/// `operator()` is noexcept and allocates nothing.
class Driver {
 public:
  /// \throws std::invalid_argument if a parameter is out of range.
  Driver(const Arm& arm,
         const ParameterSet& parameters,
         const DrivenWorld& world,
         const std::vector<Rule>& rules = {});

  [[nodiscard]] policies::Command operator()(const policies::Senses& senses) noexcept;

  /// After the last tick that was certified; a default without a law and rules.
  [[nodiscard]] const CertifiedTick& certified() const noexcept { return now_.certified; }
  [[nodiscard]] const policies::Policy& policy() const noexcept { return policy_; }

 private:
  struct Gate {
    Runtime runtime;
    policies::GuardedDrive drive;
  };
  void certify(const Tick& tick) noexcept;
  [[nodiscard]] policies::Command acted_on(const policies::Command& wanted,
                                           const Pose& pose) noexcept;

  policies::PolicyParameters parameters_;
  policies::Policy policy_;
  bool guards_act_;
  std::optional<SpeedLaw> law_;
  double control_s_;
  std::int64_t tick_ns_;
  std::optional<Gate> gate_;
  RuntimeTick now_;
  std::optional<std::int64_t> next_tick_ns_;
  bool broke_ = false;  ///< The log has a gap since the last tick that was certified.
  double commanded_mps_ = kMissing;
};

}  // namespace tcert::study
