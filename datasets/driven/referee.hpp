#pragma once
/// \file
/// How a driven trial ends, and what is counted until then.

#include <cstdint>
#include <tcert/region.hpp>

#include "datasets/bundle.hpp"
#include "datasets/driven/body.hpp"
#include "datasets/driven/wedge_watch.hpp"

namespace tcert {

/// What happened in a trial, beside its end.
struct DrivenEvents {
  double peak_force_n = 0.0;
  double time_above_s = 0.0;     ///< With a contact force above watched_force_n.
  std::uint32_t bumps = 0;       ///< Contacts of the body, 0.25 s or more after the last.
  std::uint32_t stalls = 0;      ///< See WedgeWatch.
  std::uint32_t recoveries = 0;  ///< See WedgeWatch.
  double crash_force_n = 0.0;    ///< That would have ended, or ended, this trial.
};

/// Judges one trial by the true motion of its body; nothing is settled before.
///
/// *Goal*: the body's middle came into G, stayed there, and stood for stand_s, by itself or because
/// it was told to after stop_inside_m of way inside. The trial's time and distance are those of the
/// entry after which it stayed. Whoever leaves G before has not arrived. *Collision*: a contact
/// force above crash_force_n. *Wedged*: see WedgeWatch. *Timeout*: none of these by time_limit_s,
/// an unfinished stay in G included.
class Referee {
 public:
  Referee(const DriveParameters& parameters, const Region& goal, double crash_force_n, Point start);

  /// The next `seconds` of the trial, which end at `now_s`, with what was commanded in them.
  void watch(double now_s, double seconds, const policies::Command& command, const Body& body);

  /// True while the robot is to stand in G, whatever its policy commands.
  [[nodiscard]] bool told_to_stand() const noexcept { return told_to_stand_; }

  /// unknown while the trial goes on.
  [[nodiscard]] EndReason end_reason() const noexcept { return end_reason_; }
  [[nodiscard]] double time_s() const noexcept { return time_s_; }
  [[nodiscard]] double distance_m() const noexcept { return distance_m_; }
  [[nodiscard]] DrivenEvents events() const noexcept;

 private:
  void watch_force(double now_s, double seconds, double force_n) noexcept;
  void watch_goal(double now_s, double seconds, double speed_cmd_mps, const Body& body) noexcept;
  void finish(EndReason reason, double time_s, double distance_m) noexcept;

  DriveParameters parameters_;
  const Region& goal_;
  WedgeWatch wedge_;
  DrivenEvents events_;
  double last_contact_s_;
  bool inside_ = false;
  double entered_s_ = 0.0;
  double entered_m_ = 0.0;
  double stood_s_ = 0.0;
  bool told_to_stand_ = false;
  EndReason end_reason_ = EndReason::unknown;
  double time_s_ = 0.0;
  double distance_m_ = 0.0;
};

}  // namespace tcert
