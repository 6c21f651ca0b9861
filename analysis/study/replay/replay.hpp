#pragma once
/// \file
/// A logged run driven again at gated speed on the same path (paper 3.5, H3).

#include <cstddef>
#include <optional>
#include <span>
#include <tcert/certifier.hpp>
#include <tcert/runtime.hpp>
#include <vector>

#include "analysis/study/replay/replay_options.hpp"
#include "datasets/ticks.hpp"

namespace tcert::study {

/// What a run and its replay come to, from its first fresh tick to the first inside G, or to the
/// end of the log.
struct Replay {
  double length_m = 0.0;      ///< Of the path, where the log moves.
  double time_s = 0.0;        ///< As logged.
  double gated_time_s = 0.0;  ///< Re-timed.
  double slow_s = 0.0;        ///< Part of both times: standing still and breaks of the path.
  std::optional<double> speed_cmd_mps;        ///< Median over the logged time; NA without commands.
  std::optional<double> gated_speed_cmd_mps;  ///< Median over the re-timed time.
  std::size_t stalls = 0;
  double stall_m = 0.0;          ///< Path in stalls.
  double creep_m = 0.0;          ///< Path without forward speed that was too short for a stall.
  std::size_t margin_trips = 0;  ///< Times the speed law began to halt.
  std::size_t force_trips = 0;   ///< Times G2 began to trip.
  std::size_t replan_trips = 0;  ///< Times G3 began to trip.
  std::size_t alarms = 0;        ///< Times a rule began to alarm.
};

/// Metres per minute; empty if no time passed.
[[nodiscard]] std::optional<double> rate_of_advance(double length_m, double time_s);

/// What follows from every tick of a trial: guards, risk and rules, as the live loop says of the
/// same ticks, which were told to drive as logged. `actions` is reset first.
[[nodiscard]] std::vector<ActedTick> act_trial(TickActions& actions,
                                               const TickTable& ticks,
                                               std::span<const CertifiedTick> series);

/// Path geometry unchanged, the interval between two fresh ticks takes ds / v_t, v_t that of its
/// first tick. An interval in which the log stands still keeps its time and counts no length, as
/// does a break of the path. Where v_t = 0 the replay goes on at the retreat speed, and forward
/// path adds up until some tick has speed again: from `stall_m` on that is a stall, which the gated
/// robot would not have got through. Motion against the heading is a retreat and no part of a
/// stall. O(ticks log ticks). \throws std::invalid_argument if the lengths differ.
[[nodiscard]] Replay replay(const TickTable& ticks,
                            std::span<const CertifiedTick> series,
                            std::span<const ActedTick> acted,
                            const ReplayOptions& options = {});

/// A success is kept unless it stalls or takes longer than the trial limit.
[[nodiscard]] bool keeps_success(const Replay& replay, std::optional<double> limit_s);

}  // namespace tcert::study
