#pragma once
/// \file
/// Why a trial has no certificate above 0.

#include <cstdint>
#include <optional>
#include <span>
#include <tcert/certifier.hpp>
#include <tcert/robot.hpp>

#include "analysis/study/trials/certify_trial.hpp"
#include "datasets/ticks.hpp"

namespace tcert::study {

enum class NotIssuedReason : std::uint8_t {
  no_goal,        ///< The course has no G.
  no_evidence,    ///< No tick is fresh.
  start_outside,  ///< The first fresh pose lies outside S.
  goal_missed,    ///< No fresh pose lies in G.
  broken,         ///< S and G are not connected, and the path is broken between.
  unconnected,    ///< S and G are not connected.
  no_witness,     ///< Under clearance=witness: no path was found in what the run felt.
  narrow,         ///< The margin on the way is not above 0.
};

struct NotIssued {
  NotIssuedReason reason = NotIssuedReason::unconnected;
  double distance_m = 0.0;      ///< Outside S, or off G at the nearest.
  double margin_m = 0.0;        ///< Where it is narrow.
  Point place{};                ///< Where it is narrow.
  bool across_heading = false;  ///< The robot moved off its heading there.
};

/// The first reason that holds, in the order of the list; empty if a certificate was issued.
/// O(ticks), for a trial without certificate x vertices of G. \pre `series` is that of `ticks`.
[[nodiscard]] std::optional<NotIssued> why_not_issued(const Course& course,
                                                      const TickTable& ticks,
                                                      const TrialSeries& series);

}  // namespace tcert::study
