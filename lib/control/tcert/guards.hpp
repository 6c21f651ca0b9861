#pragma once
/// \file
/// Guards of the control loop, driven by the certificate (paper 5): G1 speed, G2 contact force,
/// G3 halt, retreat and replan.

#include <cstdint>
#include <tcert/certifier.hpp>
#include <tcert/parameter_fields.hpp>
#include <tcert/speed_law.hpp>
#include <tcert/tick.hpp>
#include <tcert/tracking_error.hpp>

namespace tcert {

/// What G2 and G3 do when they trip.
enum class GuardMode : std::uint8_t {
  by_law,  ///< As the paper has them: act under the clip law (5), watch under squash (3.5).
  act,     ///< Forward speed 0.
  watch,   ///< They are stated and nothing else: the speed is the speed law's.
};

/// See parameters/guards.def.
struct GuardParameters {
#define TCERT_WORD TCERT_MEMBER_WORD
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/guards.def>
};

/// See parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const GuardParameters& /*list*/, Visit&& visit) {
  using Group = GuardParameters;
#define TCERT_WORD TCERT_VISIT_WORD
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/guards.def>
}

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const GuardParameters& parameters);

/// Why forward motion is refused, or would be; or'ed.
enum GuardTrigger : std::uint32_t {
  guard_margin = 1U << 0U,       ///< The speed law gives 0: m_t <= 0 (paper 3.5).
  guard_force = 1U << 1U,        ///< G2: a tip force above F_max.
  guard_replan = 1U << 2U,       ///< G3: V_rob <= epsilon_replan.
  guard_no_bound = 1U << 3U,     ///< The tracking-error table ends below this speed or change.
  guard_no_evidence = 1U << 4U,  ///< The tick is stale or bad: there is no margin.
};

/// The guards after one tick.
struct GuardedTick {
  double tracking_error_m = kMissing;  ///< r_TE at the speed commanded before.
  double robust_margin_m = kMissing;   ///< V_rob = V_t - r_TE; -infinity without a corridor.
  double force_n = kMissing;           ///< Largest tip force; NaN if no ray states one.
  double force_limit_n = kMissing;     ///< F_max = F_min + k_F max(V_rob, 0).
  double speed_mps = 0.0;              ///< v_t, forward; a retreat runs at retreat_speed_mps.
  double retreat_speed_mps = 0.0;      ///< v_min.
  std::uint32_t triggers = 0;          ///< GuardTrigger.
  std::uint32_t began = 0;             ///< Those that the tick before did not have.
  std::uint32_t ended = 0;             ///< Those that only the tick before had.
  [[nodiscard]] bool halted() const noexcept { return speed_mps == 0.0; }
};

/// The guards of one run. The squash law is gated by the tick margin m_t, the clip law (G1) by the
/// robust margin V_rob. V and not T drives G2 and G3: T is -infinity until G is reached, and G3
/// would halt at the first tick. r_TE is that of the speed commanded at the tick before and of its
/// change over the tick before that, on the ticks' own clock.
///
/// `update` and `reset` are noexcept and allocate nothing.
class Guards {
 public:
  /// \throws std::invalid_argument if the law or the parameters are out of range.
  Guards(const SpeedLaw& law, const GuardParameters& parameters, TrackingErrorTable table);

  /// `certified` is what the certifier said of `tick`.
  GuardedTick update(const Tick& tick, const CertifiedTick& certified) noexcept;

  void reset() noexcept;

  [[nodiscard]] const SpeedLaw& law() const noexcept { return law_; }
  [[nodiscard]] const TrackingErrorTable& table() const noexcept { return table_; }

 private:
  void command(GuardedTick& now, std::int64_t time_ns) noexcept;

  SpeedLaw law_;
  GuardParameters parameters_;
  TrackingErrorTable table_;
  std::int64_t last_ns_ = 0;
  double last_speed_mps_ = 0.0;
  double last_change_mps2_ = 0.0;
  std::uint32_t last_triggers_ = 0;
  bool began_ = false;
};

}  // namespace tcert
