#pragma once
/// \file
/// Which times are one time but for rounding. Every comparison of times follows it: ties, the
/// steps of a curve that a time is looked up in, a trial limit.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

namespace tcert::statistics {

/// What was made of the distinct times.
struct TimeRounding {
  std::size_t distinct = 0;   ///< Times before.
  std::size_t kept = 0;       ///< Times after.
  double merged_step = 0.0;   ///< The widest step between two that were made one; 0 without any.
  double merged_share = 0.0;  ///< The largest such step as a share of its time.

  std::size_t by_timefix = 0;  ///< Times that R's timefix would keep.
  double timefix_step = 0.0;   ///< Its tolerance, in units of the times.
};

/// Whether two times differ by no more than rounding of themselves: 5e-7 or a millionth of
/// `time`, whichever is smaller, and at least machine epsilon times it. A difference of two stamps
/// in seconds since 1970 is as exact as 5e-7, and microseconds stay apart.
[[nodiscard]] bool same_time(double other, double time) noexcept;

/// Makes times equal that differ by rounding alone, in place; `start` and `stop` together. Sorted
/// distinct times fall to the least of their group, which reaches as far as both `same_time` and
/// R's `aeqSurv` allow: sqrt(machine epsilon), absolutely or relative to the mean |time|. R has
/// the second alone, and by neighbours: one stamp among seconds, or stamps alone, then chain whole
/// seconds into one. Every estimator here expects it to have been done, or left out on purpose.
/// O(n log n).
TimeRounding round_times(SurvivalOutcome& outcome);

/// What `round_times` would find and does not do: `kept` is `distinct`. O(n log n).
[[nodiscard]] TimeRounding count_times(const SurvivalOutcome& outcome);

/// The time of the ascending steps that `asked` is but for rounding: itself if it is among them,
/// else the nearest; `asked` if there is none. `time_of(step)`. O(log steps).
template <class Steps, class TimeOf>
[[nodiscard]] double step_time(const Steps& steps, double asked, const TimeOf& time_of) {
  const auto next =
      std::lower_bound(std::begin(steps), std::end(steps), asked, [&](const auto& step, double t) {
        return time_of(step) < t;
      });
  double nearest = asked;
  double distance = 0.0;
  bool found = false;
  const auto consider = [&](double time) {
    const double away = time < asked ? asked - time : time - asked;
    if (same_time(asked, time) && (!found || away < distance)) {
      nearest = time;
      distance = away;
      found = true;
    }
  };
  if (next != std::end(steps)) {
    consider(time_of(*next));
  }
  if (next != std::begin(steps)) {
    consider(time_of(*std::prev(next)));
  }
  return nearest;
}

}  // namespace tcert::statistics
