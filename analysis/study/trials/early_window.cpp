#include "analysis/study/trials/early_window.hpp"

#include <algorithm>
#include <cmath>

namespace tcert::study {

std::int64_t nanoseconds_of(double seconds) noexcept {
  // Beyond 290 years every log has ended.
  return static_cast<std::int64_t>(std::llround(std::min(seconds, 9e9) * 1e9));
}

double seconds_of(std::int64_t nanoseconds) noexcept {
  return static_cast<double>(nanoseconds) / 1e9;
}

FreshTicks fresh_ticks(const TickTable& ticks,
                       std::span<const CertifiedTick> series,
                       std::int64_t dwell_window_ns) {
  FreshTicks fresh;
  std::vector<TimedPosition> path;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if ((series[i].flags & (flag_stale | flag_bad_input)) != 0) {
      continue;
    }
    fresh.index.push_back(i);
    fresh.since_start_ns.push_back(ticks.time_ns[i] - ticks.time_ns[0]);
    fresh.travel_m.push_back(series[i].travel_m);
    path.push_back(
        {ticks.time_ns[i], ticks.poses[i].position, (series[i].flags & flag_break) != 0});
  }
  fresh.motion = trailing_motion(path, dwell_window_ns);
  return fresh;
}

Window time_window(const FreshTicks& fresh, std::int64_t end_ns, double limit_s) {
  const std::int64_t limit_ns = nanoseconds_of(limit_s);
  const auto after =
      std::upper_bound(fresh.since_start_ns.begin(), fresh.since_start_ns.end(), limit_ns);
  Window window;
  window.size = static_cast<std::size_t>(after - fresh.since_start_ns.begin());
  if (end_ns > limit_ns) {
    window.end_s = limit_s;
  }
  return window;
}

Window distance_window(const FreshTicks& fresh, std::int64_t end_ns, double limit_m, double cap_s) {
  Window window = time_window(fresh, end_ns, cap_s);
  const auto after = std::upper_bound(fresh.travel_m.begin(), fresh.travel_m.end(), limit_m);
  const auto size = static_cast<std::size_t>(after - fresh.travel_m.begin());
  if (size < window.size) {
    window = {size, seconds_of(fresh.since_start_ns[size])};
  }
  return window;
}

}  // namespace tcert::study
