#pragma once
/// \file
/// What rules said of one trial, held against what really happened and what was injected.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tcert/runtime.hpp>
#include <vector>

#include "analysis/study/assurance/unsafe_episodes.hpp"
#include "datasets/ticks.hpp"

namespace tcert::study {

/// A fault that was put into a trial's log.
struct InjectedFault {
  std::string kind;
  TimeSpan time;
};

/// An episode or a fault, as one rule, or any of them, saw it.
struct Detection {
  bool detected = false;
  double delay_s =
      0.0;  ///< Of the first alarm after the beginning; negative: before it. If detected.
};

/// The same time without a fault: as long as its window, and over 5 s before it begins.
enum class Control : std::uint8_t { none, quiet, alarmed };

/// Of one rule, or of all together.
struct MonitorRecord {
  std::vector<TimeSpan> alarms;     ///< Less than 0.5 s apart as one.
  std::vector<Detection> episodes;  ///< One for each unsafe episode.
  std::vector<Detection> faults;    ///< One for each injected fault.
  std::vector<Control> controls;    ///< Likewise.
  std::size_t false_alarms = 0;     ///< Pieces of alarms outside of every episode's time.
  double false_s = 0.0;             ///< How long they are.
  double alarmed_m = 0.0;           ///< Forward way that was driven under an alarm.
};

/// What the risk field stated of the way ahead at one tick, and what was there.
struct RiskLook {
  double stated = 0.0;
  bool met = false;
};

struct AssuredTrial {
  std::string trial_id;
  std::string cluster;  ///< Day.
  double hours = 0.0;
  double forward_m = 0.0;  ///< Way along the heading.
  bool has_truth = false;  ///< Else there are no episodes, and no alarm is called false.
  std::vector<UnsafeEpisode> episodes;
  std::vector<InjectedFault> faults;
  std::vector<RiskLook> risk;           ///< Once a second; empty without risk field or truth.
  std::vector<MonitorRecord> monitors;  ///< One a rule, then that of all together.
};

/// An alarm tells of an episode if it is on at some time from 2 s before its beginning to 0.5 s
/// after it, of a fault from its beginning to 0.5 s after its end. What of it lies outside of
/// all times from 2 s before an episode to 0.5 s after it is false, each piece by itself: an alarm
/// that is always on is false between any two episodes.
/// A wall counts as met if the body cannot go `ahead_m` straight on. \pre one acted tick a tick,
/// `rules` of them.
[[nodiscard]] AssuredTrial assure_trial(const TickTable& ticks,
                                        std::span<const ActedTick> acted,
                                        std::size_t rules,
                                        const std::optional<std::vector<TruthSample>>& truth,
                                        const UnsafeRule& unsafe,
                                        double ahead_m,
                                        std::vector<InjectedFault> faults);

}  // namespace tcert::study
