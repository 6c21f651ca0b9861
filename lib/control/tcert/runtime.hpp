#pragma once
/// \file
/// One tick of a control loop, the four steps of section 5 of the paper in one call.

#include <cstdint>
#include <optional>
#include <tcert/certifier.hpp>
#include <tcert/command.hpp>
#include <tcert/fallback.hpp>
#include <tcert/guards.hpp>
#include <tcert/risk_field.hpp>
#include <tcert/rule_monitor.hpp>
#include <tcert/tick_signals.hpp>
#include <vector>

namespace tcert {

/// What acts on a certificate.
struct ActionSetup {
  GuardSetup guards;
  std::optional<RiskParameters> risk;  ///< None: no risk field is kept.
  std::vector<Rule> rules;             ///< None: nothing is monitored, and nothing falls back.
  FallbackParameters fallback;
};

/// What follows from a certified tick.
struct ActedTick {
  GuardedTick guarded;
  /// Chance of a collision over risk_ahead_m straight ahead of the body; NaN without a risk field.
  double risk_ahead = kMissing;
  std::uint32_t alarms = 0;  ///< 1 << rule, or'ed.
  std::uint32_t alarms_began = 0;
  std::uint32_t alarms_ended = 0;
};

/// Steps 2 to 4 of a tick, for ticks that are certified: of the live loop, a replay and a drive
/// alike.
///
/// 2. r_TE at the speed granted and V_rob.
/// 3. The speed and force envelopes (G1, G2), and the risk of what lies ahead. Candidate headings
/// are
///    compared by risk()->integral_along().
/// 4. Where V_rob <= epsilon or a guard trips, `guarded` halts and asks for a new route
///    (RoutePlanner); where a rule alarms, step() backs out.
///
/// The constructor takes all memory; every other member is noexcept and allocates nothing.
class TickActions {
 public:
  /// \throws std::invalid_argument if a part of the setup is out of range; std::bad_alloc.
  explicit TickActions(ActionSetup setup);

  void reset() noexcept;

  /// `commanded` is what the robot was told to drive when the tick was felt, as far as it is known
  /// (NaN): the rules look at its speed, the barrier law goes by its yaw rate.
  ActedTick update(const Tick& tick,
                   const CertifiedTick& certified,
                   const Command& commanded = {kMissing, kMissing}) noexcept;

  /// What to command in the place of `wanted` for the next `seconds`, at a tick or between two: the
  /// barrier law's filter, and the fallback of an alarm of the last tick, of a rule that acts. The
  /// speed that the other laws grant is in `guarded`, and taking it is left to who commands. The
  /// filter leaves a forward command at least `least_mps`, for a robot that would else stand for
  /// good where it touches; an infeasible one, too. A command that is not finite halts.
  Command step(const Command& wanted,
               const Pose& pose,
               double seconds,
               double least_mps = 0.0) noexcept;

  [[nodiscard]] const Guards& guards() const noexcept { return guards_; }
  [[nodiscard]] const RuleMonitor& monitor() const noexcept { return monitor_; }
  [[nodiscard]] const Fallback& fallback() const noexcept { return fallback_; }
  [[nodiscard]] const RiskField* risk() const noexcept { return risk_ ? &*risk_ : nullptr; }

 private:
  void observe(const Tick& tick, const CertifiedTick& certified) noexcept;

  Robot robot_;
  Guards guards_;
  std::optional<RiskParameters> risk_parameters_;
  std::optional<RiskField> risk_;
  std::vector<double> longest_m_;
  double slack_m_;
  std::optional<TickSignals> signals_;  // if there are rules
  RuleMonitor monitor_;
  Fallback fallback_;
  bool began_ = false;
  std::int64_t first_ns_ = 0;
  std::int64_t monitored_ns_ = 0;  // time of the last tick, for the rules
  std::uint32_t alarms_ = 0;
  int wider_side_ = 1;
};

/// Everything of a tick.
struct RuntimeTick {
  CertifiedTick certified;
  ActedTick acted;
};

/// A control loop's whole tick:
///
///     Runtime runtime(course, setup);
///     for (;;) {
///       const Tick tick = sense();
///       const RuntimeTick now = runtime.update(tick);
///       drive(runtime.step({now.acted.guarded.speed_mps, yaw_rate}, tick.pose, 0.1));
///     }
///
/// Step 1 takes the tick up into memory and corridor graph (Certifier); 2 to 4 are TickActions.
class Runtime {
 public:
  /// \throws std::invalid_argument, std::bad_alloc.
  Runtime(const Course& course, const ActionSetup& setup);

  /// The robot was told to drive what step() returned last; nothing is known before its first call.
  RuntimeTick update(const Tick& tick) noexcept { return update(tick, commanded_); }
  /// It was told something else, or by somebody else.
  RuntimeTick update(const Tick& tick, const Command& commanded) noexcept;

  /// See TickActions::step.
  Command step(const Command& wanted,
               const Pose& pose,
               double seconds,
               double least_mps = 0.0) noexcept {
    commanded_ = actions_.step(wanted, pose, seconds, least_mps);
    return commanded_;
  }
  void reset() noexcept;

  [[nodiscard]] const Certifier& certifier() const noexcept { return certifier_; }
  [[nodiscard]] const TickActions& actions() const noexcept { return actions_; }

 private:
  Certifier certifier_;
  TickActions actions_;
  Command commanded_{kMissing, kMissing};
};

}  // namespace tcert
