#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tcert/guards.hpp>
#include <utility>

namespace tcert {
namespace {

double largest_force(std::span<const RayReading> rays) noexcept {
  double largest = kMissing;
  for (const RayReading& ray : rays) {
    largest = std::fmax(largest, ray.fsr_n);
  }
  return largest;
}

}  // namespace

void validate(const GuardParameters& p) { require_fields(p); }

Guards::Guards(const SpeedLaw& law, const GuardParameters& parameters, TrackingErrorTable table)
    : law_(law), parameters_(parameters), table_(std::move(table)) {
  validate(law);
  validate(parameters);
}

void Guards::reset() noexcept {
  last_speed_mps_ = last_change_mps2_ = 0.0;
  last_triggers_ = 0;
  began_ = false;
}

GuardedTick Guards::update(const Tick& tick, const CertifiedTick& certified) noexcept {
  GuardedTick now;
  now.retreat_speed_mps = law_.min_speed_mps;
  if ((certified.flags & (flag_stale | flag_bad_input)) != 0) {
    now.triggers = guard_no_evidence;
    command(now, tick.time_ns);
    return now;
  }
  now.tracking_error_m =
      table_.radius_m(last_speed_mps_, last_change_mps2_, parameters_.disturbance);
  now.robust_margin_m = certified.corridor_value_m - now.tracking_error_m;
  now.force_n = largest_force(tick.rays);
  now.force_limit_n =
      parameters_.min_force_n + parameters_.force_per_m * std::max(now.robust_margin_m, 0.0);
  now.speed_mps =
      gated_speed(law_, law_.kind == SpeedLawKind::clip ? now.robust_margin_m : certified.margin_m);
  now.triggers |= now.speed_mps > 0.0 ? 0U : guard_margin;
  now.triggers |= now.force_n > now.force_limit_n ? guard_force : 0U;
  now.triggers |= now.robust_margin_m > parameters_.replan_margin_m ? 0U : guard_replan;
  now.triggers |= std::isinf(now.tracking_error_m) ? guard_no_bound : 0U;
  const bool acting = parameters_.mode == GuardMode::act ||
                      (parameters_.mode == GuardMode::by_law && law_.kind == SpeedLawKind::clip);
  if (acting && now.triggers != 0) {
    now.speed_mps = 0.0;
  }
  command(now, tick.time_ns);
  return now;
}

// Remembers what was commanded, for the bound of the next tick. A clock that does not advance, as
// in a bad tick, leaves the change of speed unknown, hence without bound.
void Guards::command(GuardedTick& now, std::int64_t time_ns) noexcept {
  now.began = now.triggers & ~last_triggers_;
  now.ended = last_triggers_ & ~now.triggers;
  const double elapsed_s = tcert::elapsed_s(last_ns_, time_ns);
  const double change_mps = std::abs(now.speed_mps - last_speed_mps_);
  if (!began_ || change_mps == 0.0) {
    last_change_mps2_ = 0.0;
  } else {
    last_change_mps2_ =
        elapsed_s > 0.0 ? change_mps / elapsed_s : std::numeric_limits<double>::infinity();
  }
  began_ = true;
  last_ns_ = time_ns;
  last_speed_mps_ = now.speed_mps;
  last_triggers_ = now.triggers;
}

}  // namespace tcert
