#include <algorithm>
#include <cmath>
#include <tcert/felt_clearance.hpp>
#include <tcert/runtime.hpp>
#include <utility>

namespace tcert {

TickActions::TickActions(ActionSetup setup)
    : robot_(setup.guards.robot),
      guards_(setup.guards),
      risk_parameters_(setup.risk),
      slack_m_(setup.guards.certificate.contact_slack_m),
      monitor_(std::move(setup.rules)),
      fallback_(setup.fallback, robot_.min_turn_radius_m) {
  if (risk_parameters_) {
    validate(*risk_parameters_, robot_);
    risk_.emplace(*risk_parameters_);
  }
  if (!monitor_.rules().empty()) {
    validate(robot_, setup.guards.certificate);
    signals_.emplace(robot_, setup.guards.certificate);
  }
  for (const Ray& ray : robot_.rays) {
    longest_m_.push_back(longest_clearance(ray));
  }
}

void TickActions::reset() noexcept {
  guards_.reset();
  if (risk_) {
    risk_->clear();
  }
  if (signals_) {
    signals_->reset();
  }
  monitor_.reset();
  fallback_.reset();
  began_ = false;
  monitored_ns_ = 0;
  alarms_ = 0;
  wider_side_ = 1;
}

void TickActions::observe(const Tick& tick, const CertifiedTick& certified) noexcept {
  if (certified.left_m != certified.right_m) {
    wider_side_ = certified.right_m > certified.left_m ? -1 : 1;
  }
  if (!risk_) {
    return;
  }
  const double time_s = elapsed_s(first_ns_, tick.time_ns);
  for (std::size_t k = 0; k < robot_.rays.size() && k < tick.rays.size(); ++k) {
    const Ray& ray = robot_.rays[k];
    const double clear_m = felt_clearance(ray, tick.rays[k]);
    if (!std::isnan(clear_m)) {
      const double bearing_rad = bearing_of(ray, tick.rays[k].bearing_rad);
      risk_->observe_ray(transform(tick.pose, ray.mount),
                         direction(tick.pose.yaw_rad + bearing_rad),
                         clear_m,
                         clear_m < longest_m_[k] - slack_m_,
                         time_s);
    }
  }
  risk_->observe_body(tick.pose.position, 0.5 * robot_.body_width_m, time_s);
}

ActedTick TickActions::update(const Tick& tick,
                              const CertifiedTick& certified,
                              const Command& commanded) noexcept {
  ActedTick acted;
  const bool is_bad = (certified.flags & flag_bad_input) != 0;
  // The time of a bad tick may be anything: for the rules it comes just after the one before.
  monitored_ns_ = is_bad || tick.time_ns <= monitored_ns_ ? monitored_ns_ + 1 : tick.time_ns;
  if (!is_bad && !std::exchange(began_, true)) {
    first_ns_ = tick.time_ns;
    monitored_ns_ = tick.time_ns;
  }
  acted.guarded = guards_.update(tick, certified, {kMissing, commanded.yaw_rate_rps});
  if ((certified.flags & (flag_stale | flag_bad_input)) == 0) {
    observe(tick, certified);
    if (risk_) {
      const Point ahead = direction(tick.pose.yaw_rad);
      acted.risk_ahead =
          risk_->collision_probability(tick.pose.position + 0.5 * robot_.body_width_m * ahead,
                                       ahead,
                                       risk_parameters_->ahead_m,
                                       robot_.body_width_m,
                                       elapsed_s(first_ns_, tick.time_ns));
    }
  }
  if (signals_) {
    acted.alarms = monitor_.update(
        monitored_ns_, signals_->take(tick, certified, acted.guarded, acted.risk_ahead, commanded));
  }
  acted.alarms_began = acted.alarms & ~alarms_;
  acted.alarms_ended = alarms_ & ~acted.alarms;
  alarms_ = acted.alarms;
  return acted;
}

Command TickActions::step(const Command& wanted,
                          const Pose& pose,
                          double seconds,
                          double least_mps) noexcept {
  if (!std::isfinite(wanted.speed_mps) || !std::isfinite(wanted.yaw_rate_rps) ||
      !std::isfinite(seconds)) {
    return {};
  }
  Command kept = guards_.filtered(wanted, pose, seconds).command;
  if (kept.speed_mps < least_mps && wanted.speed_mps > kept.speed_mps) {
    const double least = std::min(least_mps, wanted.speed_mps);
    kept = {least, wanted.yaw_rate_rps * (least / wanted.speed_mps)};
  }
  return fallback_.step(kept, (alarms_ & monitor_.acting()) != 0, pose, wider_side_, seconds);
}

Runtime::Runtime(const Course& course, const ActionSetup& setup)
    : certifier_(setup.guards.robot, course, setup.guards.certificate), actions_(setup) {}

RuntimeTick Runtime::update(const Tick& tick, const Command& commanded) noexcept {
  RuntimeTick now;
  now.certified = certifier_.update(tick);
  now.acted = actions_.update(tick, now.certified, commanded);
  return now;
}

void Runtime::reset() noexcept {
  certifier_.reset();
  actions_.reset();
  commanded_ = {kMissing, kMissing};
}

}  // namespace tcert
