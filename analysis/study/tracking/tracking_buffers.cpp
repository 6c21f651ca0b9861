#include "analysis/study/tracking/tracking_buffers.hpp"

#include <algorithm>
#include <cmath>
#include <tcert/elementary.hpp>
#include <tcert/geometry.hpp>
#include <tcert/segment.hpp>

namespace tcert::study {
namespace {

/// Heading over travel of a path that is walked forward.
class HeadingOverTravel {
 public:
  HeadingOverTravel(double window_m, double deadband_m)
      : window_m_(window_m), deadband_m_(deadband_m) {}

  /// Adds where the path is. `yaw_rad` is its heading there; NaN: the direction of its steps.
  void add(Point position, double yaw_rad) {
    if (counted_.empty()) {
      counted_.push_back({position, 0.0, yaw_rad});
      return;
    }
    const Counted& last = counted_.back();
    const double step_m = distance(last.position, position);
    if (step_m < deadband_m_) {
      return;
    }
    const Point way = position - last.position;
    double heading = std::isnan(yaw_rad) ? elementary::atan2(way.y_m, way.x_m) : yaw_rad;
    if (!std::isnan(last.heading_rad)) {
      heading = last.heading_rad + wrapped_angle(heading - last.heading_rad);
    }
    counted_.push_back({position, last.travel_m + step_m, heading});
    const Counted& now = counted_.back();
    while (counted_[begin_ + 1].travel_m <= now.travel_m - window_m_) {
      ++begin_;
    }
    const Counted& from = counted_[begin_];
    const bool is_whole =
        now.travel_m - from.travel_m >= window_m_ && !std::isnan(from.heading_rad);
    curvature_ =
        is_whole ? (now.heading_rad - from.heading_rad) / (now.travel_m - from.travel_m) : kMissing;
  }

  [[nodiscard]] double curvature_per_m() const noexcept { return curvature_; }
  [[nodiscard]] double travel_m() const noexcept {
    return counted_.empty() ? 0.0 : counted_.back().travel_m;
  }

 private:
  struct Counted {
    Point position;
    double travel_m;
    double heading_rad;
  };

  double window_m_;
  double deadband_m_;
  std::vector<Counted> counted_;
  std::size_t begin_ = 0;
  double curvature_ = kMissing;
};

/// The distance of sample `i` to the nominal path within lag_s of its time; `begin` is that of the
/// sample before, from which the search goes on.
double path_distance(const std::vector<TrackedSample>& samples,
                     std::size_t i,
                     double lag_s,
                     std::size_t& begin) {
  const Point executed = samples[i].executed.position;
  while (samples[begin].time_s < samples[i].time_s - lag_s) {
    ++begin;
  }
  double nearest = distance(executed, samples[begin].nominal);
  for (std::size_t k = begin + 1;
       k < samples.size() && samples[k].time_s <= samples[i].time_s + lag_s;
       ++k) {
    nearest = std::min(nearest,
                       distance_to_segment(executed, samples[k - 1].nominal, samples[k].nominal));
  }
  return nearest;
}

RunErrors errors_of(const TrackingRun& run,
                    const TrackingRuns& runs,
                    const TrackingOptions& options) {
  RunErrors errors;
  errors.run = run.run;
  errors.day = run.day;
  errors.samples = run.samples.size();
  HeadingOverTravel executed(options.window_m, options.deadband_m);
  HeadingOverTravel nominal(options.window_m, options.deadband_m);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const TrackedSample& sample = run.samples[i];
    const double path_m = path_distance(run.samples, i, options.lag_s, begin);
    if (i == 0 || path_m > errors.path_m) {
      errors.path_m = path_m;
      errors.path_time_s = sample.time_s;
    }
    errors.same_time_m =
        std::max(errors.same_time_m, distance(sample.executed.position, sample.nominal));
    executed.add(sample.executed.position, sample.executed.yaw_rad);
    nominal.add(sample.nominal, kMissing);
    const double driven = runs.has_curvature ? sample.curvature_per_m : executed.curvature_per_m();
    const double planned =
        runs.has_nominal_curvature ? sample.nominal_curvature_per_m : nominal.curvature_per_m();
    const double difference = std::abs(driven - planned);
    if (!std::isnan(difference) && difference > errors.curvature_per_m.value_or(-1.0)) {
      errors.curvature_per_m = difference;
      errors.curvature_time_s = sample.time_s;
    }
    if (!std::isnan(difference)) {
      errors.excess_per_m =
          std::max(errors.excess_per_m.value_or(0.0), std::abs(driven) - std::abs(planned));
    }
  }
  errors.travel_m = executed.travel_m();
  return errors;
}

}  // namespace

TrackingBuffers tracking_buffers(const TrackingRuns& runs, const TrackingOptions& options) {
  TrackingBuffers buffers;
  buffers.days = runs.days;
  for (const TrackingRun& run : runs.runs) {
    const RunErrors errors = errors_of(run, runs, options);
    buffers.path_m = std::max(buffers.path_m, errors.path_m);
    buffers.same_time_m = std::max(buffers.same_time_m, errors.same_time_m);
    if (errors.curvature_per_m) {
      buffers.curvature_per_m =
          std::max(buffers.curvature_per_m.value_or(0.0), *errors.curvature_per_m);
    } else {
      ++buffers.without_curvature;
    }
    buffers.runs.push_back(errors);
  }
  return buffers;
}

double wilks_confidence(std::size_t n, double share) {
  return 1.0 - elementary::exp(static_cast<double>(n) * elementary::log(share));
}

double wilks_share(std::size_t n, double confidence) {
  return elementary::exp(elementary::log(1.0 - confidence) / static_cast<double>(n));
}

}  // namespace tcert::study
