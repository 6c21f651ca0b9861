#include "analysis/study/witness/felt_samples.hpp"

#include <witness/tick_samples.hpp>

namespace tcert::study {

witness::Samples felt_samples(const TickTable& ticks, const Robot& robot) {
  witness::TickSamples felt(robot);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    felt.add(ticks[i]);
  }
  return felt.samples();
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
