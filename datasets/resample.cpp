#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "datasets/empty_samples.hpp"
#include "datasets/stream_clock.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

namespace {

constexpr int kMostMedianSamples = 9;
constexpr std::int64_t kLongestSilenceNs = 60'000'000'000;

/// Median of the values that are not missing; the mean of the middle two if their number is even.
class MedianWindow {
 public:
  void add(double value, double bearing_rad = kMissing) noexcept {
    if (std::isnan(value)) {
      return;
    }
    std::size_t place = size_++;
    for (; place > 0 && values_[place - 1] > value; --place) {
      values_[place] = values_[place - 1];
      bearings_[place] = bearings_[place - 1];
    }
    values_[place] = value;
    bearings_[place] = bearing_rad;
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] double median() const noexcept {
    if (size_ == 0) {
      return kMissing;
    }
    const double upper = values_[size_ / 2];
    const bool is_felt = size_ % 2 == 1 || !std::isnan(bearing_rad());
    return is_felt ? upper : 0.5 * (values_[size_ / 2 - 1] + upper);
  }

  /// Where a ray that a joint moves pointed when it felt the median: what it felt elsewhere is not
  /// mixed with it, so that of two values in the middle the greater one is taken.
  [[nodiscard]] double bearing_rad() const noexcept {
    return size_ == 0 ? kMissing : bearings_[size_ / 2];
  }

 private:
  std::array<double, kMostMedianSamples> values_{};    // ascending
  std::array<double, kMostMedianSamples> bearings_{};  // of each
  std::size_t size_ = 0;
};

/// Walks a stream forward: how many of its samples are at or before an instant.
class StreamPosition {
 public:
  explicit StreamPosition(const std::vector<std::int64_t>& time_ns) noexcept : time_ns_(time_ns) {}

  void advance_to(std::int64_t time_ns) noexcept {
    while (passed_ < time_ns_.size() && time_ns_[passed_] <= time_ns) {
      ++passed_;
    }
  }

  [[nodiscard]] std::size_t passed() const noexcept { return passed_; }

  /// \pre passed() > 0.
  [[nodiscard]] std::size_t newest() const noexcept { return passed_ - 1; }

  /// Of the newest sample; of a stream that has not begun, older than anything.
  [[nodiscard]] std::int64_t age_ns(std::int64_t now_ns) const noexcept {
    return passed_ > 0 ? now_ns - time_ns_[newest()] : INT64_MAX;
  }

  /// Time of the next sample, or of the last one if all are passed.
  [[nodiscard]] std::int64_t next_ns() const noexcept {
    return passed_ < time_ns_.size() ? time_ns_[passed_] : time_ns_.back();
  }

 private:
  const std::vector<std::int64_t>& time_ns_;
  std::size_t passed_ = 0;
};

/// One forward pass over the streams of a trial.
class Resampler {
 public:
  Resampler(const TrialLog& log, const ResampleOptions& options)
      : log_(log),
        hold_ns_(to_nanoseconds(options.max_hold_s)),
        median_samples_(static_cast<std::size_t>(options.median_samples)),
        pose_(log.pose.time_ns),
        tactile_(log.tactile.time_ns),
        control_(log.control.time_ns) {
    ticks_.rays = log.tactile.rays;
  }

  void add_tick(std::int64_t now_ns) {
    pose_.advance_to(now_ns);
    control_.advance_to(now_ns);
    const bool starts_segment = pass_breaks(now_ns);
    tactile_.advance_to(now_ns);
    ticks_.time_ns.push_back(now_ns);
    ticks_.poses.push_back(log_.pose.poses[pose_.newest()]);
    const bool stale = pose_.age_ns(now_ns) > hold_ns_ || tactile_.age_ns(now_ns) > hold_ns_;
    ticks_.stale.push_back(stale ? 1 : 0);
    ticks_.segment_start.push_back(starts_segment ? 1 : 0);
    const bool commanded = control_.passed() > 0;
    ticks_.speed_cmd_mps.push_back(commanded ? log_.control.speed_cmd_mps[control_.newest()]
                                             : kMissing);
    ticks_.yaw_rate_cmd_rps.push_back(commanded ? log_.control.yaw_rate_cmd_rps[control_.newest()]
                                                : kMissing);
    add_readings(now_ns);
  }

  /// Where the next tick may be: after a silence of both streams longer than a minute the grid is
  /// taken up again at the next sample, so that a wrong clock cannot ask for any number of ticks.
  [[nodiscard]] std::int64_t skip_silence(std::int64_t tick_ns, std::int64_t period_ns) const {
    const std::int64_t since = std::min(pose_.age_ns(tick_ns), tactile_.age_ns(tick_ns));
    const std::int64_t resumes = std::min(pose_.next_ns(), tactile_.next_ns());
    if (since <= kLongestSilenceNs || resumes <= tick_ns) {
      return tick_ns;
    }
    return tick_ns + (resumes - tick_ns) / period_ns * period_ns;
  }

  [[nodiscard]] TickTable take() { return std::move(ticks_); }

 private:
  /// True if the path breaks between the last tick and this one. Samples before a break are not
  /// mixed with those after it.
  bool pass_breaks(std::int64_t now_ns) noexcept {
    bool any = false;
    while (next_break_ < log_.breaks_ns.size() && log_.breaks_ns[next_break_] <= now_ns) {
      tactile_.advance_to(log_.breaks_ns[next_break_] - 1);
      ++next_break_;
      any = true;
    }
    if (any) {
      segment_begin_ = tactile_.passed();
    }
    return any;
  }

  // The newest samples of each ray that hold a value: rays of a tactile.csv may have rates of their
  // own, with empty cells between. The last rows count whatever their age, older ones only while
  // they would not make a tick stale.
  void add_readings(std::int64_t now_ns) {
    const std::size_t end = tactile_.passed();
    if (end == 0) {
      ticks_.readings.resize(ticks_.readings.size() + log_.tactile.rays);
      return;
    }
    // The newest sample counts even if it is older than the break: its tick is then stale.
    const std::size_t segment = std::min(segment_begin_, end - 1);
    const std::size_t recent = end - std::min(end, median_samples_);
    const std::size_t rays = log_.tactile.rays;
    for (std::size_t k = 0; k < rays; ++k) {
      MedianWindow value;
      MedianWindow force;
      for (std::size_t i = end; i-- > segment;) {
        const bool counts = i >= recent || now_ns - log_.tactile.time_ns[i] <= hold_ns_;
        if (!counts || (value.size() == median_samples_ && force.size() == median_samples_)) {
          break;
        }
        const RayReading& reading = log_.tactile.readings[i * rays + k];
        if (value.size() < median_samples_) {
          value.add(reading.value, reading.bearing_rad);
        }
        if (force.size() < median_samples_) {
          force.add(reading.fsr_n);
        }
      }
      ticks_.readings.push_back({value.median(), force.median(), value.bearing_rad()});
    }
  }

  const TrialLog& log_;
  std::int64_t hold_ns_;
  std::size_t median_samples_;
  StreamPosition pose_;
  StreamPosition tactile_;
  StreamPosition control_;
  std::size_t next_break_ = 0;
  std::size_t segment_begin_ = 0;
  TickTable ticks_;
};

}  // namespace

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
    resampler.add_tick(tick_ns);
    tick_ns = resampler.skip_silence(tick_ns + period_ns, period_ns);
  }
  return resampler.take();
}

}  // namespace tcert
