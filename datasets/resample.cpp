#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "datasets/empty_samples.hpp"
#include "datasets/resampler.hpp"
#include "datasets/stream_clock.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

void validate(const ResampleOptions& options) {
  require_fields(options);
  if (options.median_samples % 2 == 0) {
    throw std::invalid_argument("median_samples is " + std::to_string(options.median_samples) +
                                "; it must be odd");
  }
}

TickTable resample(const TrialLog& log, const ResampleOptions& options) {
  validate(options);
  if (log.merged) {
    return *log.merged;
  }
  if (auto kept = without_empty_samples(log.tactile)) {
    TrialLog samples = log;
    samples.tactile = std::move(*kept);
    return resample(samples, options);
  }
  Resampler resampler(log, options);
  if (log.pose.time_ns.empty() || log.tactile.time_ns.empty()) {
    return resampler.take();
  }
  const std::int64_t period_ns = to_nanoseconds(options.tick_s);
  const std::int64_t last_ns = std::min(log.pose.time_ns.back(), log.tactile.time_ns.back());
  std::int64_t tick_ns = log.pose.time_ns.front();
  if (!log.starts_with_pose) {
    tick_ns = std::max(tick_ns, log.tactile.time_ns.front());
  }
  while (tick_ns <= last_ns) {
    if (resampler.has_begun(tick_ns)) {
      resampler.add_tick(tick_ns);
    }
    tick_ns = resampler.skip_silence(tick_ns + period_ns, period_ns);
  }
  return resampler.take();
}

}  // namespace tcert
