#pragma once
/// \file
/// Guards of the control loop, driven by the certificate (paper 5): G1 speed, G2 contact force,
/// G3 halt, retreat and replan.

#include <cstdint>
#include <optional>
#include <tcert/barrier_law.hpp>
#include <tcert/certifier.hpp>
#include <tcert/command.hpp>
#include <tcert/felt_points.hpp>
#include <tcert/parameter_fields.hpp>
#include <tcert/speed_law.hpp>
#include <tcert/speed_left.hpp>
#include <tcert/tick.hpp>
#include <tcert/tracking_error.hpp>

namespace tcert {

/// What G2 and G3 do when they trip.
enum class GuardMode : std::uint8_t {
  by_law,  ///< Watch under squash, as the paper has it (3.5); act under all others (5), which never
           ///< halt.
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
  guard_barrier = 1U << 5U,      ///< No command keeps the barrier of what was felt.
};

/// The guards after one tick.
struct GuardedTick {
  double tracking_error_m = kMissing;  ///< r_TE at the speed granted, or refused.
  double robust_margin_m = kMissing;   ///< V_rob at that speed; -infinity without a corridor.
  double force_n = kMissing;           ///< Largest tip force; NaN if no ray states one.
  double force_limit_n = kMissing;     ///< F_max = F_min + k_F max(V_rob, 0).
  double speed_mps = 0.0;              ///< v_t, forward; a retreat runs at retreat_speed_mps.
  double yaw_rate_rps = 0.0;           ///< As wanted, but for what the barrier law changes.
  double retreat_speed_mps = 0.0;      ///< v_min.
  std::uint32_t triggers = 0;          ///< GuardTrigger.
  std::uint32_t began = 0;             ///< Those that the tick before did not have.
  std::uint32_t ended = 0;             ///< Those that only the tick before had.
  [[nodiscard]] bool halted() const noexcept { return speed_mps == 0.0; }
};

/// How often r_TE is taken off a margin: twice off a width, as the tracking buffer is, once off a
/// radius.
[[nodiscard]] double tracking_shares(ClearanceReading clearance) noexcept;

/// What guards are made from.
struct GuardSetup {
  Robot robot;
  CertificateParameters certificate;
  SpeedLaw law;
  GuardParameters parameters;
  TrackingErrorTable table;
};

/// The guards of one run. Squash and profile are gated by the tick margin m_t, the clip law (G1) by
/// the robust margin V_rob = V_t - k r_TE, k = tracking_shares(). V and not T drives G2 and G3: T
/// is -infinity until G is reached, and G3 would halt at the first tick.
///
/// **r_TE depends on the speed that it limits.** It is that of the speed granted now, with the
/// change from the speed granted before (or, by the table's second axis, the speed just left), on
/// the ticks' own clock. Under the clip law v = law(V - k r_TE(v)) has a solution, for the law is
/// continuous and never below v_min: what is granted is the larger end of where it can be kept
/// (and, where the guards act, with V_rob above replan_margin_m), to within (v_max - v_min) 2^-30,
/// and v_min where nowhere; of the speeds below the last one, where braking may cost more than it
/// gains, 32 are looked at. Under squash no such speed need exist, for it falls from v_min to 0 at
/// once; it goes by m_t. Were r_TE that of the speed before, a halt would lower r_TE, which would
/// end the halt, which would raise it again: a robot would halt and go at every other tick.
///
/// `update` and `reset` are noexcept and allocate nothing.
class Guards {
 public:
  /// \throws std::invalid_argument if the law or the parameters are out of range.
  explicit Guards(GuardSetup setup);

  /// `certified` is what the certifier said of `tick`. `wanted` is what the barrier law filters:
  /// v_max straight on unless something else is.
  GuardedTick update(const Tick& tick,
                     const CertifiedTick& certified,
                     const Command& wanted = {kMissing, 0.0}) noexcept;

  /// Under the barrier law a command between two ticks, at `pose`, so that it keeps what was felt
  /// up to the last tick for `period_s` more; under the others as it is.
  [[nodiscard]] FilteredCommand filtered(const Command& wanted,
                                         const Pose& pose,
                                         double period_s) const noexcept;

  void reset() noexcept;

  [[nodiscard]] const SpeedLaw& law() const noexcept { return setup_.law; }
  [[nodiscard]] const TrackingErrorTable& table() const noexcept { return setup_.table; }
  /// r_TE of going on at a speed, k times.
  [[nodiscard]] double shares_of_error_m(double speed_mps) const noexcept;

 private:
  [[nodiscard]] bool acts() const noexcept;
  [[nodiscard]] double error_at(double speed_mps) const noexcept;
  [[nodiscard]] double fixed_point(double corridor_value_m) const noexcept;
  [[nodiscard]] double wanted_speed(const Tick& tick,
                                    const CertifiedTick& certified,
                                    const Command& wanted,
                                    GuardedTick& now) const noexcept;
  void command(GuardedTick& now, std::int64_t time_ns) noexcept;

  GuardSetup setup_;
  double shares_;
  std::optional<FeltPoints> felt_;  // of the barrier and profile laws
  double period_s_ = 0.0;           // since the tick before
  std::int64_t last_ns_ = 0;
  double last_speed_mps_ = 0.0;
  SpeedLeft left_;
  double left_mps_ = 0.0;  // what counts of it at this tick
  std::uint32_t last_triggers_ = 0;
  bool began_ = false;
};

}  // namespace tcert
