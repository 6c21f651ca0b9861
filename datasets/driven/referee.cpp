#include "datasets/driven/referee.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tcert {
namespace {

constexpr double kBetweenBumps = 0.25;   // s
constexpr double kStandingStill = 1e-3;  // m/s

}  // namespace

Referee::Referee(const DriveParameters& parameters,
                 const Region& goal,
                 double crash_force_n,
                 Point start)
    : parameters_(parameters),
      goal_(goal),
      wedge_(parameters, start),
      last_contact_s_(-std::numeric_limits<double>::infinity()) {
  events_.crash_force_n = crash_force_n;
}

void Referee::watch(double now_s,
                    double seconds,
                    const policies::Command& command,
                    const Body& body) {
  const double force_n = body.hold().force_n;
  watch_force(now_s, seconds, force_n);
  watch_goal(now_s, seconds, command.speed_mps, body);
  wedge_.watch(seconds, command.speed_mps, force_n > 0.0, body.pose().position);
  if (end_reason_ != EndReason::unknown) {
    return;
  }
  if (force_n > events_.crash_force_n) {
    finish(EndReason::collision, now_s, body.travelled_m());
  } else if (wedge_.wedged()) {
    finish(EndReason::wedged, now_s, body.travelled_m());
  } else if (now_s >= parameters_.time_limit_s) {
    finish(EndReason::timeout, now_s, body.travelled_m());
  }
}

void Referee::watch_force(double now_s, double seconds, double force_n) noexcept {
  if (force_n <= 0.0) {
    return;
  }
  events_.peak_force_n = std::max(events_.peak_force_n, force_n);
  events_.time_above_s += force_n > parameters_.watched_force_n ? seconds : 0.0;
  events_.bumps += now_s - seconds - last_contact_s_ >= kBetweenBumps ? 1U : 0U;
  last_contact_s_ = now_s;
}

void Referee::watch_goal(double now_s,
                         double seconds,
                         double speed_cmd_mps,
                         const Body& body) noexcept {
  if (!contains(goal_, body.pose().position)) {
    inside_ = false;
    told_to_stand_ = false;
    stood_s_ = 0.0;
    return;
  }
  if (!inside_) {
    inside_ = true;
    entered_s_ = now_s;
    entered_m_ = body.travelled_m();
  }
  const bool stands = speed_cmd_mps == 0.0 && body.speed_mps() <= kStandingStill;
  stood_s_ = stands ? stood_s_ + seconds : 0.0;
  told_to_stand_ = told_to_stand_ || body.travelled_m() - entered_m_ >= parameters_.stop_inside_m;
  if (stood_s_ >= parameters_.stand_s) {
    finish(EndReason::goal, entered_s_, entered_m_);
  }
}

DrivenEvents Referee::events() const noexcept {
  DrivenEvents events = events_;
  events.stalls = wedge_.stalls();
  events.recoveries = wedge_.recoveries();
  return events;
}

void Referee::finish(EndReason reason, double time_s, double distance_m) noexcept {
  end_reason_ = reason;
  time_s_ = std::round(time_s * 1e3) / 1e3;
  distance_m_ = std::round(distance_m * 1e4) / 1e4;
}

}  // namespace tcert
