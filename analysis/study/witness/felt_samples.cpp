#include "analysis/study/witness/felt_samples.hpp"

#include <vector>

namespace tcert::study {

witness::Samples felt_samples(const TickTable& ticks, const Robot& robot) {
  TickTable fresh;
  fresh.rays = ticks.rays;
  std::vector<std::int64_t> breaks_ns;
  bool broken = false;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    broken = broken || ticks.segment_start[i] != 0;
    if (ticks.stale[i] != 0) {
      continue;
    }
    if (broken) {
      breaks_ns.push_back(ticks.time_ns[i]);
    }
    broken = false;
    fresh.time_ns.push_back(ticks.time_ns[i]);
    fresh.poses.push_back(ticks.poses[i]);
    const Tick tick = ticks[i];
    fresh.readings.insert(fresh.readings.end(), tick.rays.begin(), tick.rays.end());
  }
  return witness::at_touch_times(
      robot, {fresh.time_ns, fresh.poses}, {fresh.time_ns, fresh.readings}, breaks_ns, 0.0);
}

witness::Samples felt_samples(const TrialLog& log, const Robot& robot, double pose_bridge_s) {
  if (log.merged) {
    return felt_samples(*log.merged, robot);
  }
  return witness::at_touch_times(robot,
                                 {log.pose.time_ns, log.pose.poses},
                                 {log.tactile.time_ns, log.tactile.readings},
                                 log.breaks_ns,
                                 pose_bridge_s);
}

}  // namespace tcert::study
