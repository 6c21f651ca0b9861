#include <witness/tick_samples.hpp>

namespace tcert::witness {

void TickSamples::add(const Tick& tick) {
  is_after_break_ = is_after_break_ || tick.segment_start;
  if (!tick.stale && add_sample(samples_, robot_, tick.pose, tick.rays, is_after_break_, tick.time_ns)) {
    is_after_break_ = false;
  }
}

}  // namespace tcert::witness
