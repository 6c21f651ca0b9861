#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tcert/guards.hpp>
#include <tcert/speed_profile.hpp>
#include <utility>

namespace tcert {
namespace {

constexpr double kTickPeriod = 0.1;     // of a first tick
constexpr double kLongestPeriod = 1.0;  // s
constexpr int kBisections = 30;
constexpr int kBrakingSpeeds = 32;

double largest_force(std::span<const RayReading> rays) noexcept {
  double largest = kMissing;
  for (const RayReading& ray : rays) {
    largest = std::fmax(largest, ray.fsr_n);
  }
  return largest;
}

}  // namespace

void validate(const GuardParameters& p) { require_fields(p); }

double tracking_shares(ClearanceReading clearance) noexcept {
  return clearance == ClearanceReading::radial ? 1.0 : 2.0;
}

Guards::Guards(GuardSetup setup)
    : setup_(std::move(setup)), shares_(tracking_shares(setup_.certificate.clearance)) {
  validate(setup_.law);
  validate(setup_.parameters);
  if (setup_.law.kind == SpeedLawKind::barrier || setup_.law.kind == SpeedLawKind::profile) {
    validate(setup_.robot, setup_.certificate);
    felt_.emplace(setup_.robot, setup_.certificate);
  }
}

void Guards::reset() noexcept {
  last_speed_mps_ = 0.0;
  last_triggers_ = 0;
  left_.reset();
  left_mps_ = 0.0;
  began_ = false;
  if (felt_) {
    felt_->clear();
  }
}

double Guards::shares_of_error_m(double speed_mps) const noexcept {
  const TrackingErrorTable& table = setup_.table;
  const double second = table.has_speed_left() ? speed_mps : 0.0;
  return shares_ * table.radius_m(speed_mps, second, setup_.parameters.disturbance);
}

// A clock that does not advance, as in a bad tick, leaves the change of speed unknown, hence
// without bound.
double Guards::error_at(double speed_mps) const noexcept {
  const TrackingErrorTable& table = setup_.table;
  double second = 0.0;
  if (table.has_speed_left()) {
    second = std::max(left_mps_, speed_mps);
  } else if (began_ && speed_mps != last_speed_mps_) {
    second = period_s_ > 0.0 ? std::abs(speed_mps - last_speed_mps_) / period_s_
                             : std::numeric_limits<double>::infinity();
  }
  return table.radius_m(speed_mps, second, setup_.parameters.disturbance);
}

bool Guards::acts() const noexcept {
  return setup_.parameters.mode == GuardMode::act ||
         (setup_.parameters.mode == GuardMode::by_law && setup_.law.kind != SpeedLawKind::squash);
}

// The speeds that can be kept reach from some speed downwards as long as r_TE rises with the speed,
// that is from the last speed up; below it, braking may cost more than it gains.
double Guards::fixed_point(double corridor_value_m) const noexcept {
  const SpeedLaw& law = setup_.law;
  const auto can_be_kept = [&](double speed_mps) noexcept {
    const double margin_m = corridor_value_m - shares_ * error_at(speed_mps);
    return speed_mps <= gated_speed(law, margin_m) &&
           (!acts() || margin_m > setup_.parameters.replan_margin_m);
  };
  double high = law.max_speed_mps;
  if (can_be_kept(high)) {
    return high;
  }
  double low = law.min_speed_mps;
  if (last_speed_mps_ > low && last_speed_mps_ < high && can_be_kept(last_speed_mps_)) {
    low = last_speed_mps_;
  } else if (!can_be_kept(low)) {
    // Braking may cost more than it gains: some speed between may hold where neither end does.
    const double top = std::min(last_speed_mps_, high);
    const double step = (top - low) / kBrakingSpeeds;
    int i = kBrakingSpeeds - 1;
    while (i > 0 && !(step > 0.0 && can_be_kept(low + i * step))) {
      --i;
    }
    if (i == 0) {
      return low;
    }
    high = low + (i + 1) * step;
    low += i * step;
  }
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (can_be_kept(middle) ? low : high) = middle;
  }
  return low;
}

FilteredCommand Guards::filtered(const Command& wanted,
                                 const Pose& pose,
                                 double period_s) const noexcept {
  if (setup_.law.kind != SpeedLawKind::barrier) {
    return {wanted, true};
  }
  return barrier_command(
      wanted, *felt_, pose, 0.5 * setup_.robot.body_width_m, period_s, setup_.law);
}

double Guards::wanted_speed(const Tick& tick,
                            const CertifiedTick& certified,
                            const Command& wanted,
                            GuardedTick& now) const noexcept {
  const SpeedLaw& law = setup_.law;
  switch (law.kind) {
    case SpeedLawKind::clip:
      return fixed_point(certified.corridor_value_m);
    case SpeedLawKind::barrier: {
      const double speed_mps = std::isnan(wanted.speed_mps) ? law.max_speed_mps : wanted.speed_mps;
      const FilteredCommand kept = filtered({speed_mps, now.yaw_rate_rps}, tick.pose, period_s_);
      now.triggers |= kept.feasible ? 0U : guard_barrier;
      now.yaw_rate_rps = kept.command.yaw_rate_rps;
      return std::max(kept.command.speed_mps, 0.0);
    }
    case SpeedLawKind::profile:
      return profile_speed(
          law, gated_speed(law, certified.margin_m), felt_->front_m(), last_speed_mps_, period_s_);
    case SpeedLawKind::squash:
      break;
  }
  return gated_speed(law, certified.margin_m);
}

GuardedTick Guards::update(const Tick& tick,
                           const CertifiedTick& certified,
                           const Command& wanted) noexcept {
  GuardedTick now;
  const SpeedLaw& law = setup_.law;
  const GuardParameters& parameters = setup_.parameters;
  now.retreat_speed_mps = law.min_speed_mps;
  now.yaw_rate_rps = std::isnan(wanted.yaw_rate_rps) ? 0.0 : wanted.yaw_rate_rps;
  if ((certified.flags & (flag_stale | flag_bad_input)) != 0) {
    now.triggers = guard_no_evidence;
    // The time of a bad tick may be anything: it is not looked at.
    command(now, (certified.flags & flag_bad_input) != 0 ? last_ns_ : tick.time_ns);
    return now;
  }
  period_s_ = began_ ? std::min(elapsed_s(last_ns_, tick.time_ns), kLongestPeriod) : kTickPeriod;
  left_mps_ = left_.at(tick.time_ns);
  if (felt_) {
    felt_->add(tick, certified.travel_m);
  }
  now.speed_mps = wanted_speed(tick, certified, wanted, now);
  const double asked_mps = now.speed_mps > 0.0 ? now.speed_mps : law.min_speed_mps;
  now.tracking_error_m = error_at(asked_mps);
  now.robust_margin_m = certified.corridor_value_m - shares_ * now.tracking_error_m;
  now.force_n = largest_force(tick.rays);
  now.force_limit_n =
      parameters.min_force_n + parameters.force_per_m * std::max(now.robust_margin_m, 0.0);
  now.triggers |= now.speed_mps > 0.0 || (now.triggers & guard_barrier) != 0 ? 0U : guard_margin;
  now.triggers |= now.force_n > now.force_limit_n ? guard_force : 0U;
  now.triggers |= now.robust_margin_m > parameters.replan_margin_m ? 0U : guard_replan;
  now.triggers |= std::isinf(now.tracking_error_m) ? guard_no_bound : 0U;
  if (acts() && now.triggers != 0) {
    now.speed_mps = 0.0;
  }
  command(now, tick.time_ns);
  return now;
}

// Remembers what was granted, for the bound of the next tick.
void Guards::command(GuardedTick& now, std::int64_t time_ns) noexcept {
  now.began = now.triggers & ~last_triggers_;
  now.ended = last_triggers_ & ~now.triggers;
  if (setup_.table.has_speed_left()) {
    left_.command(now.speed_mps, setup_.table.hold_s(now.speed_mps), time_ns);
  }
  began_ = began_ || (now.triggers & guard_no_evidence) == 0;
  last_ns_ = time_ns;
  last_speed_mps_ = now.speed_mps;
  last_triggers_ = now.triggers;
}

}  // namespace tcert
