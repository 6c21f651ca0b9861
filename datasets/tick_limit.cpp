#include "datasets/tick_limit.hpp"

#include <algorithm>
#include <cstdint>

namespace tcert {
namespace {

constexpr double kMostTicks = 0x1p24;
constexpr double kLongestSilenceSeconds = 60.0;  // which resample() fills with ticks

double span_in_seconds(const std::vector<std::int64_t>& time_ns) {
  double span_s = 0.0;
  for (std::size_t i = 1; i < time_ns.size(); ++i) {
    const double gap_s =
        1e-9 * (static_cast<double>(time_ns[i]) - static_cast<double>(time_ns[i - 1]));
    span_s += std::min(gap_s, kLongestSilenceSeconds);
  }
  return span_s;
}

}  // namespace

void reject_too_many_ticks(std::optional<TrialLog>& log,
                           double tick_s,
                           const std::string& trial_id,
                           std::vector<table::Diagnostic>& diagnostics) {
  if (!log || log->merged) {
    return;
  }
  const double ticks =
      std::max(span_in_seconds(log->pose.time_ns), span_in_seconds(log->tactile.time_ns)) / tick_s;
  if (ticks > kMostTicks) {
    diagnostics.push_back({table::Severity::error,
                           "logs/" + trial_id,
                           0,
                           "time_s",
                           std::to_string(static_cast<std::int64_t>(ticks)) + " ticks of tick_s",
                           "stamps that span at most 16777216; raise tick_s or cut the log",
                           1});
    log.reset();
  }
}

}  // namespace tcert
