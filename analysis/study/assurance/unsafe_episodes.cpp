#include "analysis/study/assurance/unsafe_episodes.hpp"

#include <algorithm>

namespace tcert::study {
namespace {

constexpr double kJoin = 0.5;  // s
constexpr double kShortest = 0.2;
constexpr double kMoving = 0.01;  // m/s

double seconds_of(std::int64_t time_ns) { return 1e-9 * static_cast<double>(time_ns); }

}  // namespace

std::vector<TimeSpan> joined_spans(std::vector<TimeSpan> spans, double join_s, double least_s) {
  std::vector<TimeSpan> joined;
  for (const TimeSpan& span : spans) {
    if (!joined.empty() && span.begin_s - joined.back().end_s < join_s) {
      joined.back().end_s = std::max(joined.back().end_s, span.end_s);
    } else {
      joined.push_back(span);
    }
  }
  std::erase_if(joined,
                [&](const TimeSpan& span) { return span.end_s - span.begin_s < least_s - 1e-9; });
  return joined;
}

double stopping_way_m(double speed_mps, const UnsafeRule& rule) noexcept {
  const double forward = std::max(speed_mps, 0.0);
  return forward * rule.reaction_s + forward * forward / (2.0 * rule.brake_mps2);
}

bool is_collision_ahead(const TruthSample& sample,
                        double speed_mps,
                        const UnsafeRule& rule) noexcept {
  return speed_mps > kMoving && sample.free_ahead_m < kTruthAhead &&
         stopping_way_m(speed_mps, rule) > sample.free_ahead_m;
}

std::vector<UnsafeEpisode> unsafe_episodes(std::span<const TruthSample> truth,
                                           const UnsafeRule& rule) {
  std::vector<TimeSpan> spans;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (is_collision_ahead(truth[i], truth[i].speed_mps, rule) || truth[i].force_n > rule.force_n) {
      const std::size_t next = std::min(i + 1, truth.size() - 1);
      spans.push_back({seconds_of(truth[i].time_ns), seconds_of(truth[next].time_ns)});
    }
  }
  std::vector<UnsafeEpisode> episodes;
  for (const TimeSpan& span : joined_spans(std::move(spans), kJoin, kShortest)) {
    episodes.push_back({span});
  }
  std::size_t at = 0;
  for (const TruthSample& sample : truth) {
    const double now_s = seconds_of(sample.time_ns);
    while (at < episodes.size() && now_s > episodes[at].time.end_s) {
      ++at;
    }
    if (at < episodes.size() && now_s >= episodes[at].time.begin_s) {
      episodes[at].ahead |= is_collision_ahead(sample, sample.speed_mps, rule);
      episodes[at].force |= sample.force_n > rule.force_n;
    }
  }
  return episodes;
}

}  // namespace tcert::study
