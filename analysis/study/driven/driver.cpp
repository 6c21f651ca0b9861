#include "analysis/study/driven/driver.hpp"

#include <cmath>
#include <tcert/speed_gate.hpp>

#include "analysis/study/driven/fitted_policies.hpp"
#include "analysis/study/replay/replay_trial.hpp"
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
          parameters.drive.control_s,
          parameters.risk};
}

ActionSetup actions_of(const Arm& arm,
                       const ParameterSet& parameters,
                       const std::vector<Rule>& rules) {
  ActionSetup setup = actions_of(with_overrides(corpus_robot(), parameters.robot),
                                 parameters,
                                 arm.law.value_or(parameters.speed_law),
                                 TrackingErrorTable());
  setup.guards.parameters.mode = arm.guards ? GuardMode::act : GuardMode::watch;
  if (arm.monitor) {
    setup.rules = rules;
  }
  return setup;
}

}  // namespace

policies::PolicyParameters parameters_of(const Arm& arm, const ParameterSet& parameters) {
  policies::PolicyParameters own = parameters.policy;
  const FittedPolicy& fitted = fitted_policy(arm.policy);
  own.cruise_mps = parameters.policy_overrides.cruise_mps.value_or(fitted.cruise_mps);
  own.caution = parameters.policy_overrides.caution.value_or(fitted.caution);
  own.lookahead_m = parameters.policy_overrides.lookahead_m.value_or(fitted.lookahead_m);
  own.lambda_weight = arm.lambda_weight.value_or(own.lambda_weight);
  own.risk_weight = arm.without_memory ? 0.0 : own.risk_weight;
  return own;
}

Driver::Driver(const Arm& arm,
               const ParameterSet& parameters,
               const DrivenWorld& world,
               const std::vector<Rule>& rules)
    : parameters_(parameters_of(arm, parameters)),
      policy_(arm.policy, setup_of(arm, parameters, world)),
      guards_act_(arm.guards),
      law_(arm.law),
      control_s_(parameters.drive.control_s),
      tick_ns_(std::llround(parameters.resample.tick_s * 1e9)) {
  if (arm.law || arm.monitor) {
    gate_.emplace(
        Gate{Runtime({world.world.start, world.world.goal}, actions_of(arm, parameters, rules)),
             policies::GuardedDrive(parameters_, control_s_)});
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
  now_ = gate_->runtime.update(taken);
}

policies::Command Driver::acted_on(const policies::Command& wanted, const Pose& pose) noexcept {
  policies::Command command = wanted;
  const GuardedTick& guarded = now_.acted.guarded;
  if (guards_act_) {
    command = gate_->drive.step(command, guarded, pose);
    if (gate_->drive.replans()) {
      policy_.give_up_lane();
    }
  } else if (law_) {
    const bool is_filtered = law_->kind == SpeedLawKind::barrier;
    command = policies::at_granted_speed(
        command, is_filtered ? law_->max_speed_mps : guarded.speed_mps, parameters_);
  }
  return gate_->runtime.step(command, pose, control_s_, parameters_.creep_mps);
}

policies::Command Driver::operator()(const policies::Senses& senses) noexcept {
  policies::Senses told = senses;
  told.commanded_mps = commanded_mps_;
  policies::Command command = policy_.step(told);
  if (gate_) {
    certify(senses.tick);
    command = acted_on(command, senses.tick.pose);
  }
  commanded_mps_ = command.speed_mps;
  return command;
}

}  // namespace tcert::study
