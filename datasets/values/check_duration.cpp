#include "datasets/values/check_duration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tcert/tick.hpp>

namespace tcert {
namespace {

constexpr double kLeastTrialS = 1.0;
constexpr double kMostTimes = 10.0;

}  // namespace

std::optional<ValueFinding> check_duration(const TrialRow& trial, const TickTable& ticks) {
  if (!trial.time_s || *trial.time_s <= 0.0 || ticks.size() == 0) {
    return std::nullopt;
  }
  const double log_s = elapsed_s(ticks.time_ns.front(), ticks.time_ns.back());
  if (std::max(log_s, *trial.time_s) <= kLeastTrialS ||
      (log_s <= kMostTimes * *trial.time_s && kMostTimes * log_s >= *trial.time_s)) {
    return std::nullopt;
  }
  return value_finding(
      ValueKind::duration,
      "time_s",
      fmt::format("a log of {:.4g} s", log_s),
      fmt::format("about the {:.4g} s that trials.csv says: {}",
                  *trial.time_s,
                  log_s > *trial.time_s ? "milliseconds or another unit?"
                                        : "another unit, or a log that breaks off?"));
}

}  // namespace tcert
