#include "datasets/values/check_course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tcert/region.hpp>

#include "datasets/worlds/region_distance.hpp"

namespace tcert {
namespace {

/// From the nearest fresh pose to the region; infinite without any.
double nearest_to(const Region& region, const TickTable& ticks) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = ticks.size(); i-- > 0 && nearest_m > 0.0;) {
    if (ticks.stale[i] == 0) {
      const Point here = ticks.poses[i].position;
      nearest_m = contains(region, here) ? 0.0 : std::min(nearest_m, region_distance(region, here));
    }
  }
  return nearest_m;
}

}  // namespace

std::vector<ValueFinding> check_course(const Course& course,
                                       const std::optional<bool>& success,
                                       const TickTable& ticks) {
  std::vector<ValueFinding> found;
  const auto first = std::ranges::find(ticks.stale, 0);
  if (first == ticks.stale.end()) {
    return found;
  }
  const Point start = ticks.poses[static_cast<std::size_t>(first - ticks.stale.begin())].position;
  if (course.start && !contains(*course.start, start)) {
    found.push_back(
        value_finding(ValueKind::start_outside,
                      "",
                      fmt::format("a first tick {:.3g} m outside the start region",
                                  region_distance(*course.start, start)),
                      "a run that starts in S; otherwise there is never a certificate"));
  }
  if (course.goal && contains(*course.goal, start)) {
    found.push_back(value_finding(ValueKind::goal_at_start,
                                  "",
                                  "a first pose in the goal region",
                                  "a run that enters G later: where S and G overlap there is "
                                  "nothing to pass, and the certificate says nothing"));
  }
  if (course.goal && success.value_or(false)) {
    const double nearest_m = nearest_to(*course.goal, ticks);
    if (nearest_m > 0.0) {
      found.push_back(value_finding(
          ValueKind::goal_missed,
          "",
          fmt::format("a success that never entered the goal region, {:.3g} m off at the nearest",
                      nearest_m),
          "a success that ends in G; without it there is no certificate"));
    }
  }
  return found;
}

std::optional<table::Diagnostic> check_goal_is_known(const Course& course) {
  if (course.goal) {
    return std::nullopt;
  }
  return table::Diagnostic{table::Severity::note,
                           "bundle.json",
                           0,
                           course.start ? "course.goal" : "course",
                           "",
                           "a goal region G; without it there is no certificate T_t, only V_t",
                           1};
}

}  // namespace tcert
