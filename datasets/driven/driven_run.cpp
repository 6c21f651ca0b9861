#include "datasets/driven/driven_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tcert/elementary.hpp>
#include <utility>

#include "datasets/corpus/streams.hpp"
#include "datasets/driven/driven_draws.hpp"

namespace tcert {
namespace {

DrivenDesign checked(DrivenDesign design) {
  validate(design);
  return design;
}

TrialLog empty_log() {
  TrialLog log;
  log.tactile.rays = kTentacles;
  return log;
}

std::int64_t nanoseconds(double seconds) { return std::llround(1e9 * seconds); }

double drawn_crash_force(const DrivenDesign& design) {
  table::RandomStream random(design.seed, draws::kDrivenCrash, design.index);
  return design.parameters.crash_force_n *
         elementary::exp(design.parameters.crash_log_sd * random.normal());
}

}  // namespace

DrivenRun::DrivenRun(DrivenDesign design)
    : design_(checked(std::move(design))),
      step_ns_(nanoseconds(design_.parameters.step_s)),
      control_ns_(nanoseconds(design_.parameters.control_s)),
      walls_(walls_of(design_.world, kSensingRange)),
      body_(design_.parameters,
            walls_,
            0.5 * corpus_robot().body_width_m,
            design_.world.start,
            design_.world.relief),
      referee_(design_.parameters,
               *design_.world.world.goal,
               drawn_crash_force(design_),
               design_.world.start.position),
      sensors_(design_, walls_),
      latency_random_(noise_seed(design_), draws::kDrivenLatency, design_.index),
      log_(empty_log()),
      resampler_(log_, ResampleOptions{}) {
  const double clear = walls_.distance_from(design_.world.start.position);
  if (clear < 0.5 * corpus_robot().body_width_m) {
    throw std::invalid_argument("world '" + design_.world.world.name +
                                "': the body does not fit at its start");
  }
  if (design_.truth) {
    truth_.emplace(walls_, 0.5 * corpus_robot().body_width_m);
  }
  senses_.goal = middle_of(*design_.world.world.goal);
  if (design_.camera) {
    camera_.emplace(design_.parameters,
                    walls_of(design_.world, design_.parameters.camera_range_m),
                    design_.lighting,
                    design_.mirrored,
                    table::RandomStream(noise_seed(design_), draws::kDrivenCamera, design_.index));
  }
}

const policies::Senses* DrivenRun::next() {
  do {
    next_control_ns_ += control_ns_;
    drive_until(next_control_ns_);
    if (referee_.end_reason() != EndReason::unknown) {
      return nullptr;
    }
  } while (log_.pose.time_ns.empty() || log_.tactile.time_ns.empty());
  sense();
  return &senses_;
}

void DrivenRun::take(const policies::Command& command) {
  const bool is_finite = std::isfinite(command.speed_mps) && std::isfinite(command.yaw_rate_rps);
  const policies::Command taken =
      is_finite && !referee_.told_to_stand() ? command : policies::Command{};
  const double latency_ms = draw_latency_ms(
      design_.parameters.latency_ms, design_.parameters.latency_spread_ms, latency_random_);
  const std::int64_t acts_ns = now_ns_ + std::llround(1e6 * std::max(latency_ms, 0.0));
  // No command overtakes an earlier one.
  pending_.push_back(
      {pending_.empty() ? acts_ns : std::max(acts_ns, pending_.back().from_ns), taken});
  senses_.commanded_mps = taken.speed_mps;
  log_.control.time_ns.push_back(now_ns_);
  log_.control.speed_cmd_mps.push_back(rounded_to(taken.speed_mps, 1e4));
  log_.control.yaw_rate_cmd_rps.push_back(rounded_to(taken.yaw_rate_rps, 1e4));
  log_.control.loop_latency_ms.push_back(latency_ms);
}

void DrivenRun::drive_until(std::int64_t until_ns) {
  while (now_ns_ < until_ns && referee_.end_reason() == EndReason::unknown) {
    while (!pending_.empty() && pending_.front().from_ns <= now_ns_) {
      acting_ = pending_.front().command;
      pending_.pop_front();
    }
    std::int64_t to_ns = std::min(until_ns, (now_ns_ / step_ns_ + 1) * step_ns_);
    if (!pending_.empty()) {
      to_ns = std::min(to_ns, pending_.front().from_ns);
    }
    step_to(to_ns);
  }
}

void DrivenRun::step_to(std::int64_t to_ns) {
  const Pose from = body_.pose();
  const double seconds = 1e-9 * static_cast<double>(to_ns - now_ns_);
  body_.advance(seconds, acting_);
  sensors_.feel(body_.hold(), body_.pose());
  sensors_.sample({now_ns_, to_ns, from, body_.pose(), body_.speed_mps(), body_.slip()}, log_);
  now_ns_ = to_ns;
  if (truth_) {
    truth_->take(now_ns_, body_);
  }
  referee_.watch(now_s(), seconds, acting_, body_);
}

void DrivenRun::sense() {
  senses_.tick = resampler_.add_tick(now_ns_);
  senses_.travel_m = body_.travelled_m();
  senses_.speed_mps = sensors_.measured_speed_mps(body_.forward_mps());
  senses_.bump = sensors_.read_bump();
  if (camera_) {
    senses_.camera = camera_->look(now_ns_, body_.pose());
  }
}

}  // namespace tcert
