#include "datasets/check.hpp"

#include <algorithm>
#include <iterator>
#include <tcert/region.hpp>
#include <utility>

#include "datasets/clock_steps.hpp"
#include "datasets/csv_write.hpp"

namespace tcert {

namespace {

StreamSummary summarise(const char* name, const std::vector<std::int64_t>& time_ns) {
  StreamSummary summary;
  summary.name = name;
  summary.rows = time_ns.size();
  if (const auto steps = clock_steps(time_ns)) {
    summary.rate_hz = 1.0 / steps->median_s;
    summary.longest_gap_s = steps->longest_s;
  }
  return summary;
}

std::vector<StreamSummary> summarise_streams(const TrialLog& log) {
  if (log.merged) {
    return {summarise("ticks", log.merged->time_ns)};
  }
  std::vector<StreamSummary> streams{summarise("pose", log.pose.time_ns),
                                     summarise("tactile", log.tactile.time_ns)};
  if (!log.control.time_ns.empty()) {
    streams.push_back(summarise("control", log.control.time_ns));
  }
  return streams;
}

double distance_over(const TickTable& ticks, double deadband_m) {
  double sum = 0.0;
  std::optional<Point> last;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (ticks.stale[i] != 0) {
      continue;
    }
    const Point here = ticks.poses[i].position;
    const double step = last && ticks.segment_start[i] == 0 ? distance(*last, here) : 0.0;
    if (!last || ticks.segment_start[i] != 0 || step >= deadband_m) {
      sum += step;
      last = here;
    }
  }
  return sum;
}

void summarise_ticks(const TickTable& ticks,
                     const Course& course,
                     double deadband_m,
                     TrialSummary& trial) {
  trial.ticks = ticks.size();
  trial.stale_ticks = static_cast<std::size_t>(std::ranges::count(ticks.stale, 1));
  if (ticks.size() == 0) {
    return;
  }
  trial.breaks = static_cast<std::size_t>(
      std::count(ticks.segment_start.begin() + 1, ticks.segment_start.end(), 1));
  trial.duration_s = static_cast<double>(ticks.time_ns.back() - ticks.time_ns.front()) * 1e-9;
  trial.distance_m = distance_over(ticks, deadband_m);
  if (course.start) {
    trial.starts_in_start = contains(*course.start, ticks.poses.front().position);
  }
  if (course.goal) {
    trial.ends_in_goal = contains(*course.goal, ticks.poses.back().position);
  }
}

Diagnostic starts_outside(const TrialSummary& trial, Point first) {
  std::string found = "a start at ";
  append_number(found, first.x_m);
  found += ", ";
  append_number(found, first.y_m);
  return {Severity::warning,
          "logs/" + trial.trial_id,
          0,
          "",
          std::move(found),
          "a first tick in the start region; without it there is no certificate",
          1};
}

}  // namespace

BundleCheck check_bundle(const Bundle& bundle, const CheckOptions& options) {
  BundleCheck check;
  for (const TrialRow& row : bundle.trials) {
    TrialResult read = read_trial(bundle, row, options.read);
    std::move(
        read.diagnostics.begin(), read.diagnostics.end(), std::back_inserter(check.diagnostics));
    TrialSummary trial;
    trial.trial_id = row.trial_id;
    trial.rejected = !read.log.has_value();
    if (read.log) {
      const TickTable ticks = resample(*read.log, options.resample);
      trial.streams = summarise_streams(*read.log);
      summarise_ticks(ticks, bundle.info.course, options.travel_deadband_m, trial);
      if (trial.starts_in_start == false) {
        check.diagnostics.push_back(starts_outside(trial, ticks.poses.front().position));
      }
    }
    check.trials.push_back(std::move(trial));
  }
  return check;
}

}  // namespace tcert
