#include "analysis/study/trials/not_issued.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "datasets/worlds/region_distance.hpp"

namespace tcert::study {
namespace {

/// From the nearest fresh pose to G.
double nearest_to_goal(const Region& goal, const TickTable& ticks) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (ticks.stale[i] == 0) {
      nearest_m = std::min(nearest_m, region_distance(goal, ticks.poses[i].position));
    }
  }
  return nearest_m;
}

}  // namespace

std::optional<NotIssued> why_not_issued(const Course& course,
                                        const TickTable& ticks,
                                        const TrialSeries& series) {
  if (!series.ticks.empty() && series.ticks.back().issued) {
    return std::nullopt;
  }
  NotIssued found;
  const auto because = [&found](NotIssuedReason reason) {
    found.reason = reason;
    return found;
  };
  if (!course.goal) {
    return because(NotIssuedReason::no_goal);
  }
  const auto first = std::ranges::find(ticks.stale, 0);
  if (first == ticks.stale.end()) {
    return because(NotIssuedReason::no_evidence);
  }
  const std::uint32_t flags = series.ticks.back().flags;
  if ((flags & flag_start_outside) != 0) {
    const auto i = static_cast<std::size_t>(first - ticks.stale.begin());
    found.distance_m = course.start ? region_distance(*course.start, ticks.poses[i].position) : 0.0;
    return because(NotIssuedReason::start_outside);
  }
  if ((flags & flag_goal_reached) == 0) {
    found.distance_m = nearest_to_goal(*course.goal, ticks);
    return because(NotIssuedReason::goal_missed);
  }
  if (series.bottleneck) {
    found.margin_m = series.bottleneck->margin_m;
    found.place = series.bottleneck->pose.position;
    for (std::size_t i = 0; i < std::min(ticks.size(), series.ticks.size()); ++i) {
      found.across_heading =
          found.across_heading || ((series.ticks[i].flags & flag_across_heading) != 0 &&
                                   ticks.poses[i].position == found.place);
    }
    return because(NotIssuedReason::narrow);
  }
  const bool broken = std::ranges::any_of(
      series.ticks, [](const CertifiedTick& tick) { return (tick.flags & flag_break) != 0; });
  return because(broken ? NotIssuedReason::broken : NotIssuedReason::unconnected);
}

}  // namespace tcert::study
