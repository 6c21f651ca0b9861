#pragma once
/// \file
/// What all policies share: reading the rays, following the course line, recovering, steering.

#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <tcert/felt_rays.hpp>
#include <tcert/felt_risk.hpp>
#include <tcert/headings.hpp>
#include <tcert/line_follower.hpp>
#include <tcert/policy_setup.hpp>
#include <tcert/recovery.hpp>
#include <tcert/senses.hpp>

namespace tcert::policies {

/// One step as a policy sees it.
struct Outlook {
  BodyFrame body;
  double yaw_rad = 0.0;
  std::span<const FeltRay> rays;
  std::optional<Point> bump;            ///< Where the body touches, in the odometry.
  double bearing_rad = 0.0;             ///< Of the carrot, from the heading.
  double depth = 0.0;                   ///< The deepest of the rays.
  int side = 1;                         ///< Wins ties: +1 left, -1 right.
  std::optional<double> held_turn_rad;  ///< Turn for the heading that a recovery left.
  bool gave_up = false;                 ///< A lane was given up in this step.
  bool whole = false;                   ///< All of this is known: the senses were usable.

  /// The same turn, but that straight back goes to the side that wins ties.
  [[nodiscard]] double sided(double turn_rad) const noexcept {
    return std::abs(turn_rad) >= std::numbers::pi ? side * std::numbers::pi : turn_rad;
  }
};

/// The part of a policy that does not depend on how it chooses. The constructor takes all memory;
/// every other member is noexcept.
class Pilot {
 public:
  /// \throws std::invalid_argument if the setup is out of range.
  explicit Pilot(const PolicySetup& setup);

  void reset() noexcept;

  /// Takes the senses of a step. Either it is already settled what to command (the robot recovers;
  /// or the pose is not usable or the tick stale, and it halts), or `now` holds the step.
  std::optional<Command> begin(const Senses& senses, Outlook& now) noexcept;

  /// v_cruise (1 - caution depth).
  [[nodiscard]] double cautious_speed(double depth) const noexcept;

  /// What the body can do at a speed: max_yaw_rate_rps, or less to keep its turn radius.
  [[nodiscard]] double largest_yaw_rate(double speed_mps) const noexcept;

  /// Commands to turn by `turn_rad` at a speed: a yaw rate of gain times the angle. A robot that
  /// turns on the spot (R_min = 0) drives on by the cosine of the turn.
  Command steer(const Outlook& now, double turn_rad, double speed_mps) noexcept;

  /// Commands a yaw rate at a speed, both brought within their limits.
  Command drive(double speed_mps, double yaw_rate_rps) noexcept;

  /// Adds what the risk field says of each heading, if one is kept.
  void add_risk_cost(HeadingCosts& costs, const Outlook& now) const noexcept {
    if (risk_) {
      risk_->add_cost(costs, now.body);
    }
  }

  /// The next step gives the lane up.
  void give_up_lane() noexcept { give_up_ = true; }

  [[nodiscard]] const Recovery& recovery() const noexcept { return recovery_; }
  [[nodiscard]] const LineFollower& line() const noexcept { return line_; }
  [[nodiscard]] const PolicyParameters& parameters() const noexcept { return parameters_; }

 private:
  Command command(const Command& command) noexcept;

  PolicyParameters parameters_;
  double half_width_m_;
  double min_turn_radius_m_;
  double front_cosine_;
  RayReader reader_;
  LineFollower line_;
  Recovery recovery_;
  std::optional<FeltRisk> risk_;
  int side_ = 1;
  bool give_up_ = false;
  double last_speed_mps_ = 0.0;
};

}  // namespace tcert::policies
