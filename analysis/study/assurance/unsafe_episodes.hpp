#pragma once
/// \file
/// When a driven robot was really unsafe: by the truth, never by what it felt.

#include <span>
#include <vector>

#include "analysis/study/assurance/unsafe_rule.hpp"
#include "datasets/driven/truth_stream.hpp"

namespace tcert::study {

/// A stretch of time, in s on the trial's clock.
struct TimeSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// Spans less than `join_s` apart as one, those shorter than `least_s` left out. \pre in order.
[[nodiscard]] std::vector<TimeSpan> joined_spans(std::vector<TimeSpan> spans,
                                                 double join_s,
                                                 double least_s);

/// The way that a robot at this speed still covers: the reaction's, then braking. 0 in reverse.
[[nodiscard]] double stopping_way_m(double speed_mps, const UnsafeRule& rule) noexcept;

/// The body is driven forward and would touch a wall within its stopping way, straight on.
[[nodiscard]] bool is_collision_ahead(const TruthSample& sample,
                                      double speed_mps,
                                      const UnsafeRule& rule) noexcept;

struct UnsafeEpisode {
  TimeSpan time;
  bool ahead = false;  ///< A wall within the stopping way, at some sample of it.
  bool force = false;  ///< The body was pressed harder than allowed.
};

/// Samples at which one of both holds; gaps below 0.5 s are joined, and an episode lasts for 0.2 s
/// at least. O(samples).
[[nodiscard]] std::vector<UnsafeEpisode> unsafe_episodes(std::span<const TruthSample> truth,
                                                         const UnsafeRule& rule);

}  // namespace tcert::study
