#pragma once
/// \file
/// What drives a trial in closed loop: a policy and, where its speed is gated, the certifier, the
/// speed law and the guards of the live loop.

#include <optional>
#include <tcert/certifier.hpp>
#include <tcert/guarded_drive.hpp>
#include <tcert/guards.hpp>
#include <tcert/policy.hpp>
#include <tcert/senses.hpp>

#include "analysis/study/driven/arm.hpp"
#include "analysis/study/trials/parameters.hpp"
#include "datasets/driven/driven_world.hpp"

namespace tcert::study {

/// The parameters of an arm's policy: those of the set, of which cruise and caution are the
/// policy's fitted ones unless they are set, and risk_weight is 0 without memory.
[[nodiscard]] policies::PolicyParameters parameters_of(const Arm& arm,
                                                       const ParameterSet& parameters);

/// Drives one trial. At each control step the policy commands; every tick_s the certifier takes the
/// tick of that step, as the live loop does, and the guards say what speed the law grants: the
/// squash law by m_t, the clip law by the robust margin. Without a law the policy's command stands.
///
/// `operator()` is noexcept and allocates nothing.
class Driver {
 public:
  /// \throws std::invalid_argument if a parameter is out of range.
  Driver(const Arm& arm, const ParameterSet& parameters, const DrivenWorld& world);

  [[nodiscard]] policies::Command operator()(const policies::Senses& senses) noexcept;

  /// After the last tick that was certified; a default without a law.
  [[nodiscard]] const CertifiedTick& certified() const noexcept { return certified_; }
  [[nodiscard]] const policies::Policy& policy() const noexcept { return policy_; }

 private:
  struct Gate {
    Certifier certifier;
    Guards guards;
    policies::GuardedDrive drive;
  };
  void certify(const Tick& tick) noexcept;

  policies::PolicyParameters parameters_;
  policies::Policy policy_;
  bool guards_act_;
  std::int64_t tick_ns_;
  std::optional<Gate> gate_;
  CertifiedTick certified_;
  GuardedTick guarded_;
  std::optional<std::int64_t> next_tick_ns_;
  bool broke_ = false;  ///< The log has a gap since the last tick that was certified.
  double commanded_mps_ = kMissing;
};

}  // namespace tcert::study
