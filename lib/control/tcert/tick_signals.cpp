#include <algorithm>
#include <cmath>
#include <tcert/felt_clearance.hpp>
#include <tcert/tick_signals.hpp>

namespace tcert {
namespace {

enum Signal : std::size_t {
  sig_time,
  sig_gap,
  sig_stale,
  sig_bad_input,
  sig_margin,
  sig_corridor_value,
  sig_certificate,
  sig_robust_margin,
  sig_tracking_error,
  sig_force,
  sig_force_limit,
  sig_contacts,
  sig_memory,
  sig_width,
  sig_speed_cmd,
  sig_gated_speed,
  sig_moved,
  sig_unchanged,
  sig_jump,
  sig_missing_rays,
  sig_felt_ahead,
  sig_risk_ahead,
  sig_end
};
static_assert(sig_end == kTickSignals);

constexpr std::array<SignalDoc, kTickSignals> kSignals{{
    {"time_s", "s", "since the first tick"},
    {"gap_s", "s", "since the tick before; 0 at the first"},
    {"stale", "", "1 if a required stream is silent, else 0"},
    {"bad_input", "", "1 if the tick could not be used, else 0"},
    {"margin_m", "m", "m_t"},
    {"corridor_value_m", "m", "V_t; -inf without a corridor"},
    {"certificate_m", "m", "T_t; -inf until S and G are joined"},
    {"robust_margin_m", "m", "V_t less the tracking error"},
    {"tracking_error_m", "m", "r_TE"},
    {"force_n", "N", "largest tip force"},
    {"force_limit_n", "N", "F_max of G2"},
    {"contacts", "", "rays in contact"},
    {"memory", "", "contact memory at the robot, 0 to 1"},
    {"width_m", "m", "free width across the heading"},
    {"speed_cmd_mps", "m/s", "what the robot was told to drive; negative in reverse"},
    {"gated_speed_mps", "m/s", "what law and guards grant"},
    {"moved_mps", "m/s", "way since the tick before, by its time"},
    {"unchanged_s",
     "s",
     "for how long a ray has read the same to the last digit, the longest of all; ranges of their "
     "reach, "
     "where nothing is, are not counted"},
    {"jump_m", "m", "largest change of a ray's clearance since the tick before"},
    {"missing_rays", "", "rays without a reading"},
    {"felt_ahead_m",
     "m",
     "way straight on until the body meets what a ray touched over the last body width of travel; "
     "at "
     "most the longest ray"},
    {"risk_ahead",
     "",
     "chance of a collision over risk_ahead_m straight on, if a risk field is kept"},
}};

}  // namespace

std::span<const SignalDoc> tick_signals() noexcept { return kSignals; }

std::optional<std::size_t> signal_named(std::string_view name) noexcept {
  const auto* const found =
      std::ranges::find_if(kSignals, [&](const SignalDoc& one) { return one.name == name; });
  return found == kSignals.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - kSignals.begin()));
}

TickSignals::TickSignals(const Robot& robot, const CertificateParameters& parameters)
    : rays_(robot.rays), felt_(robot, parameters), last_(robot.rays.size()) {
  for (const Ray& ray : rays_) {
    longest_m_ = std::max(longest_m_, longest_clearance(ray));
  }
}

void TickSignals::reset() noexcept {
  std::fill(last_.begin(), last_.end(), LastReading{});
  felt_.clear();
  began_ = false;
}

void TickSignals::compare_rays(const Tick& tick, double gap_s, SignalValues& now) noexcept {
  double missing = 0.0;
  double unchanged_s = kMissing;
  double jump_m = kMissing;
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    const double value = k < tick.rays.size() ? tick.rays[k].value : kMissing;
    LastReading& last = last_[k];
    if (std::isnan(value)) {
      missing += 1.0;
    } else {
      const double clear_m = felt_clearance(rays_[k], tick.rays[k]);
      const bool sees_nothing = rays_[k].kind == RayKind::range && value >= rays_[k].reach_m;
      last.unchanged_s = value == last.value && !sees_nothing ? last.unchanged_s + gap_s : 0.0;
      jump_m = std::fmax(jump_m, std::abs(clear_m - last.clear_m));
      last.value = value;
      last.clear_m = clear_m;
    }
    unchanged_s = std::fmax(unchanged_s, last.unchanged_s);
  }
  now[sig_missing_rays] = missing;
  now[sig_unchanged] = unchanged_s;
  now[sig_jump] = jump_m;
}

SignalValues TickSignals::take(const Tick& tick,
                               const CertifiedTick& certified,
                               const GuardedTick& guarded,
                               double risk_ahead,
                               const Command& commanded) noexcept {
  SignalValues now{};
  const bool is_bad = (certified.flags & flag_bad_input) != 0;
  const std::int64_t time_ns =
      is_bad ? last_ns_ : tick.time_ns;  // that of a bad tick may be anything
  if (!began_) {
    first_ns_ = last_ns_ = time_ns;
  }
  const double gap_s = std::max(elapsed_s(last_ns_, time_ns), 0.0);
  now[sig_time] = std::max(elapsed_s(first_ns_, time_ns), 0.0);
  now[sig_risk_ahead] = risk_ahead;
  now[sig_gap] = gap_s;
  now[sig_stale] = (certified.flags & flag_stale) != 0 ? 1.0 : 0.0;
  now[sig_bad_input] = (certified.flags & flag_bad_input) != 0 ? 1.0 : 0.0;
  now[sig_margin] = certified.margin_m;
  now[sig_corridor_value] = certified.corridor_value_m;
  now[sig_certificate] = certified.certificate_m;
  now[sig_robust_margin] = guarded.robust_margin_m;
  now[sig_tracking_error] = guarded.tracking_error_m;
  now[sig_force] = guarded.force_n;
  now[sig_force_limit] = guarded.force_limit_n;
  now[sig_contacts] = static_cast<double>(certified.contacts);
  now[sig_memory] = certified.memory;
  now[sig_width] = certified.width_m;
  now[sig_speed_cmd] = commanded.speed_mps;
  now[sig_gated_speed] = guarded.speed_mps;
  now[sig_moved] = began_ && !is_bad && gap_s > 0.0
                       ? distance(tick.pose.position, last_position_) / gap_s
                       : kMissing;
  now[sig_felt_ahead] = kMissing;
  if ((certified.flags & (flag_stale | flag_bad_input)) == 0) {
    felt_.add(tick, certified.travel_m);
    now[sig_felt_ahead] = felt_.free_way_m(tick.pose, longest_m_);
  }
  compare_rays(tick, gap_s, now);
  if (!is_bad) {
    began_ = true;
    last_ns_ = std::max(last_ns_, time_ns);
    last_position_ = tick.pose.position;
  }
  return now;
}

}  // namespace tcert
