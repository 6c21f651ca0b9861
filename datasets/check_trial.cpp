#include "datasets/check_trial.hpp"

#include <algorithm>
#include <tcert/geometry.hpp>
#include <tcert/region.hpp>
#include <utility>

#include "datasets/tick_limit.hpp"
#include "datasets/travelled_way.hpp"
#include "datasets/values/check_values.hpp"

namespace tcert {

namespace {

StreamCheck check_stream(const std::vector<std::int64_t>& time_ns) {
  StreamCheck check;
  check.rows = time_ns.size();
  std::vector<std::int64_t> steps_ns;
  for (std::size_t i = 1; i < time_ns.size(); ++i) {
    steps_ns.push_back(time_ns[i] - time_ns[i - 1]);
  }
  if (steps_ns.empty()) {
    return check;
  }
  std::ranges::sort(steps_ns);
  check.longest_gap_s = 1e-9 * static_cast<double>(steps_ns.back());
  const std::int64_t median_ns = steps_ns[steps_ns.size() / 2];
  if (median_ns > 0) {
    check.median_rate_hz = 1e9 / static_cast<double>(median_ns);
  }
  return check;
}

std::optional<bool> lies_in(const std::optional<Region>& region, const Pose& pose) {
  return region ? std::optional(contains(*region, pose.position)) : std::nullopt;
}

void check_ticks(const TickTable& ticks, const Course& course, TrialCheck& check) {
  check.ticks = ticks.size();
  check.stale_ticks = static_cast<std::size_t>(std::ranges::count(ticks.stale, 1));
  check.breaks = static_cast<std::size_t>(std::ranges::count(ticks.segment_start, 1));
  if (ticks.size() == 0) {
    return;
  }
  check.duration_s = 1e-9 * static_cast<double>(ticks.time_ns.back() - ticks.time_ns.front());
  check.distance_m = travelled_way(ticks).back();
  check.starts_in_start = lies_in(course.start, ticks.poses.front());
  check.ends_in_goal = lies_in(course.goal, ticks.poses.back());
}

}  // namespace

TrialCheckResult check_trial(const Bundle& bundle,
                             const TrialRow& trial,
                             const ReadOptions& read,
                             const ResampleOptions& grid,
                             const CertificateParameters& parameters) {
  TrialResult log = read_trial(bundle, trial, read);
  TrialCheckResult result;
  result.diagnostics = std::move(log.diagnostics);
  reject_too_many_ticks(log.log, grid.tick_s, trial.trial_id, result.diagnostics);
  result.check.rejected = !log.log;
  if (!log.log) {
    return result;
  }
  result.check.merged = log.log->merged.has_value();
  result.check.pose =
      check_stream(log.log->merged ? log.log->merged->time_ns : log.log->pose.time_ns);
  result.check.tactile = check_stream(log.log->tactile.time_ns);
  result.check.control = check_stream(log.log->control.time_ns);
  const TickTable ticks = resample(*log.log, grid);
  check_ticks(ticks, bundle.info.course, result.check);
  for (ValueFinding& finding : check_values(bundle.info, trial, parameters, ticks)) {
    result.diagnostics.push_back(std::move(finding.diagnostic));
  }
  return result;
}

}  // namespace tcert
