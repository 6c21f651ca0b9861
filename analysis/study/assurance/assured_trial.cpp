#include "analysis/study/assurance/assured_trial.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tcert::study {
namespace {

constexpr double kBefore = 2.0;  // s
constexpr double kAfter = 0.5;
constexpr double kJoinAlarms = 0.5;

bool meets(const TimeSpan& a, const TimeSpan& b) {
  return a.begin_s <= b.end_s && a.end_s >= b.begin_s;
}

/// The first alarm within `window`, its delay counted from `begin_s`.
Detection detected_in(const std::vector<TimeSpan>& alarms, const TimeSpan& window, double begin_s) {
  for (const TimeSpan& alarm : alarms) {
    if (meets(alarm, window)) {
      return {true, std::max(alarm.begin_s, window.begin_s) - begin_s};
    }
  }
  return {};
}

/// What is left of a span outside of `windows`, in order. \pre windows in order.
std::vector<TimeSpan> outside_of(TimeSpan span, const std::vector<TimeSpan>& windows) {
  std::vector<TimeSpan> left;
  for (const TimeSpan& window : windows) {
    if (window.end_s <= span.begin_s || window.begin_s >= span.end_s) {
      continue;
    }
    if (window.begin_s > span.begin_s) {
      left.push_back({span.begin_s, window.begin_s});
    }
    span.begin_s = std::max(span.begin_s, window.end_s);
  }
  if (span.begin_s < span.end_s) {
    left.push_back(span);
  }
  return left;
}

constexpr double kApart = 5.0;  // s

/// Whether an alarm is on in a time like that of a fault, but before it and free of others.
Control control_of(const std::vector<TimeSpan>& alarms,
                   const std::vector<InjectedFault>& faults,
                   const InjectedFault& fault,
                   double first_s) {
  const double length_s = fault.time.end_s - fault.time.begin_s + kAfter;
  const TimeSpan before{fault.time.begin_s - kApart - length_s, fault.time.begin_s - kApart};
  const bool is_free = std::ranges::none_of(faults, [&](const InjectedFault& other) {
    return meets(before, {other.time.begin_s, other.time.end_s + kAfter});
  });
  if (before.begin_s < first_s || !is_free) {
    return Control::none;
  }
  return detected_in(alarms, before, before.begin_s).detected ? Control::alarmed : Control::quiet;
}

std::vector<TimeSpan> alarms_of(const TickTable& ticks,
                                std::span<const ActedTick> acted,
                                std::uint32_t rules) {
  std::vector<TimeSpan> spans;
  for (std::size_t i = 0; i < acted.size(); ++i) {
    if ((acted[i].alarms & rules) != 0) {
      const std::size_t next = std::min(i + 1, acted.size() - 1);
      spans.push_back({1e-9 * static_cast<double>(ticks.time_ns[i]),
                       1e-9 * static_cast<double>(ticks.time_ns[next])});
    }
  }
  return joined_spans(std::move(spans), kJoinAlarms, 0.0);
}

/// Looks a second apart, so that they overlap little.
std::vector<RiskLook> risk_looks(const TickTable& ticks,
                                 std::span<const ActedTick> acted,
                                 const std::vector<TruthSample>& truth,
                                 double ahead_m) {
  std::vector<RiskLook> looks;
  std::size_t at = 0;
  std::int64_t next_ns = ticks.time_ns.empty() ? 0 : ticks.time_ns.front();
  for (std::size_t i = 0; i < acted.size(); ++i) {
    while (at + 1 < truth.size() && truth[at + 1].time_ns <= ticks.time_ns[i]) {
      ++at;
    }
    if (std::isnan(acted[i].risk_ahead) || ticks.time_ns[i] < next_ns || at >= truth.size()) {
      continue;
    }
    next_ns = ticks.time_ns[i] + 1'000'000'000;
    looks.push_back({acted[i].risk_ahead, truth[at].free_ahead_m < ahead_m});
  }
  return looks;
}

/// Way along the heading from each tick to the next; backwards counts as none.
std::vector<double> forward_ways(const TickTable& ticks) {
  std::vector<double> ways(ticks.size(), 0.0);
  for (std::size_t i = 0; i + 1 < ticks.size(); ++i) {
    const Point step = ticks.poses[i + 1].position - ticks.poses[i].position;
    ways[i] = std::max(dot(step, direction(ticks.poses[i].yaw_rad)), 0.0);
  }
  return ways;
}

}  // namespace

AssuredTrial assure_trial(const TickTable& ticks,
                          std::span<const ActedTick> acted,
                          std::size_t rules,
                          const std::optional<std::vector<TruthSample>>& truth,
                          const UnsafeRule& unsafe,
                          double ahead_m,
                          std::vector<InjectedFault> faults) {
  if (acted.size() != ticks.size()) {
    throw std::invalid_argument("assurance: actions and ticks differ in length");
  }
  AssuredTrial trial;
  trial.faults = std::move(faults);
  trial.has_truth = truth.has_value();
  if (truth) {
    trial.episodes = unsafe_episodes(*truth, unsafe);
    trial.risk = risk_looks(ticks, acted, *truth, ahead_m);
  }
  if (ticks.size() > 1) {
    trial.hours = elapsed_s(ticks.time_ns.front(), ticks.time_ns.back()) / 3600.0;
  }
  std::vector<TimeSpan> windows;
  for (const UnsafeEpisode& episode : trial.episodes) {
    windows.push_back({episode.time.begin_s - kBefore, episode.time.end_s + kAfter});
  }
  const std::vector<double> ways = forward_ways(ticks);
  for (const double way_m : ways) {
    trial.forward_m += way_m;
  }
  for (std::size_t r = 0; r <= rules; ++r) {
    const std::uint32_t of = r == rules ? ~0U : 1U << r;
    MonitorRecord record;
    record.alarms = alarms_of(ticks, acted, of);
    for (const UnsafeEpisode& episode : trial.episodes) {
      const double begin_s = episode.time.begin_s;
      record.episodes.push_back(
          detected_in(record.alarms, {begin_s - kBefore, begin_s + kAfter}, begin_s));
    }
    for (const InjectedFault& fault : trial.faults) {
      const TimeSpan window{fault.time.begin_s, fault.time.end_s + kAfter};
      record.faults.push_back(detected_in(record.alarms, window, fault.time.begin_s));
      record.controls.push_back(control_of(
          record.alarms,
          trial.faults,
          fault,
          ticks.time_ns.empty() ? 0.0 : 1e-9 * static_cast<double>(ticks.time_ns.front())));
    }
    for (const TimeSpan& alarm : record.alarms) {
      for (const TimeSpan& piece : outside_of(alarm, windows)) {
        record.false_alarms += trial.has_truth ? 1 : 0;
        record.false_s += trial.has_truth ? piece.end_s - piece.begin_s : 0.0;
      }
    }
    for (std::size_t i = 0; i < acted.size(); ++i) {
      record.alarmed_m += (acted[i].alarms & of) != 0 ? ways[i] : 0.0;
    }
    trial.monitors.push_back(std::move(record));
  }
  return trial;
}

}  // namespace tcert::study
