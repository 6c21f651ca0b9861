#include "analysis/study/driven/driver.hpp"

#include <cmath>
#include <tcert/speed_gate.hpp>

#include "analysis/study/driven/fitted_policies.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert::study {
namespace {

policies::CourseLine line_of(const DrivenWorld& driven) {
  policies::CourseLine line;
  line.low = driven.world.bounds.low;
  line.high = driven.world.bounds.high;
  for (const auto& lanes : driven.lobes) {
    line.lobes.push_back({lanes});
  }
  return line;
}

policies::PolicySetup setup_of(const Arm& arm,
                               const ParameterSet& parameters,
                               const DrivenWorld& world) {
  return {with_overrides(corpus_robot(), parameters.robot),
          line_of(world),
          parameters.certificate,
          parameters_of(arm, parameters),
          parameters.drive.control_s};
}

Guards guards_of(const Arm& arm, const ParameterSet& parameters) {
  GuardParameters of_guards = parameters.guards;
  of_guards.mode = arm.guards ? GuardMode::act : GuardMode::watch;
  return {arm.law.value_or(parameters.speed_law), of_guards, TrackingErrorTable()};
}

}  // namespace

policies::PolicyParameters parameters_of(const Arm& arm, const ParameterSet& parameters) {
  policies::PolicyParameters own = parameters.policy;
  const FittedPolicy& fitted = fitted_policy(arm.policy);
  own.cruise_mps = parameters.policy_overrides.cruise_mps.value_or(fitted.cruise_mps);
  own.caution = parameters.policy_overrides.caution.value_or(fitted.caution);
  own.lookahead_m = parameters.policy_overrides.lookahead_m.value_or(fitted.lookahead_m);
  own.risk_weight = arm.without_memory ? 0.0 : own.risk_weight;
  return own;
}

Driver::Driver(const Arm& arm, const ParameterSet& parameters, const DrivenWorld& world)
    : parameters_(parameters_of(arm, parameters)),
      policy_(arm.policy, setup_of(arm, parameters, world)),
      guards_act_(arm.guards),
      tick_ns_(std::llround(parameters.resample.tick_s * 1e9)) {
  if (arm.law) {
    gate_.emplace(Gate{Certifier(with_overrides(corpus_robot(), parameters.robot),
                                 {world.world.start, world.world.goal},
                                 parameters.certificate),
                       guards_of(arm, parameters),
                       policies::GuardedDrive(parameters_, parameters.drive.control_s)});
  }
}

void Driver::certify(const Tick& tick) noexcept {
  broke_ = broke_ || tick.segment_start;
  if (next_tick_ns_ && tick.time_ns < *next_tick_ns_) {
    return;
  }
  next_tick_ns_ = next_tick_ns_.value_or(tick.time_ns) + tick_ns_;
  Tick taken = tick;
  taken.segment_start = broke_;
  broke_ = false;
  certified_ = gate_->certifier.update(taken);
  guarded_ = gate_->guards.update(taken, certified_);
}

policies::Command Driver::operator()(const policies::Senses& senses) noexcept {
  policies::Senses told = senses;
  told.commanded_mps = commanded_mps_;
  policies::Command command = policy_.step(told);
  if (gate_) {
    certify(senses.tick);
    if (guards_act_) {
      command = gate_->drive.step(command, guarded_, senses.tick.pose);
      if (gate_->drive.replans()) {
        policy_.give_up_lane();
      }
    } else {
      command = policies::at_granted_speed(command, guarded_.speed_mps, parameters_);
    }
  }
  commanded_mps_ = command.speed_mps;
  return command;
}

}  // namespace tcert::study
