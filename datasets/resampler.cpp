#include "datasets/resampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tcert/footing.hpp>

#include "datasets/stream_clock.hpp"

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
    // Without a branch on the order, which nothing predicts: from its place on each is carried one
    // further, so that equal ones keep their order.
    bool has_place = false;
    for (std::size_t i = 0; i < size_; ++i) {
      has_place = has_place || value < values_[i];
      const double next = has_place ? values_[i] : value;
      const double next_bearing_rad = has_place ? bearings_[i] : bearing_rad;
      values_[i] = has_place ? value : values_[i];
      bearings_[i] = has_place ? bearing_rad : bearings_[i];
      value = next;
      bearing_rad = next_bearing_rad;
    }
    values_[size_] = value;
    bearings_[size_] = bearing_rad;
    ++size_;
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

}  // namespace

StreamPosition::StreamPosition(const std::vector<std::int64_t>& time_ns,
                               const std::vector<std::int64_t>& arrival_ns)
    : time_ns_(time_ns), arrival_ns_(arrival_ns), by_arrival_(arrival_ns.size()) {
  std::iota(by_arrival_.begin(), by_arrival_.end(), std::size_t{0});
  std::ranges::stable_sort(by_arrival_, {}, [&](std::size_t i) { return arrival_ns_[i]; });
}

void StreamPosition::advance_to(std::int64_t now_ns) {
  while (passed_ < time_ns_.size() && next_ns() <= now_ns) {
    if (!by_arrival_.empty()) {
      there_.insert(there_.end(), by_arrival_[passed_]);
    }
    ++passed_;
  }
}

std::size_t StreamPosition::made_before(std::int64_t time_ns) const noexcept {
  const auto at = std::ranges::lower_bound(time_ns_, time_ns);
  return static_cast<std::size_t>(at - time_ns_.begin());
}

Resampler::Resampler(const TrialLog& log, const ResampleOptions& options)
    : log_(log),
      hold_ns_(to_nanoseconds(options.max_hold_s)),
      median_samples_(static_cast<std::size_t>(options.median_samples)),
      pose_(log.pose.time_ns, log.pose.arrival_ns),
      tactile_(log.tactile.time_ns, log.tactile.arrival_ns),
      control_(log.control.time_ns, log.control.arrival_ns) {
  ticks_.rays = log.tactile.rays;
}

bool Resampler::has_begun(std::int64_t now_ns) {
  pose_.advance_to(now_ns);
  tactile_.advance_to(now_ns);
  return pose_.passed() > 0 && (log_.starts_with_pose || tactile_.passed() > 0);
}

Tick Resampler::add_tick(std::int64_t now_ns) {
  pose_.advance_to(now_ns);
  control_.advance_to(now_ns);
  const bool starts_segment = pass_breaks(now_ns);
  tactile_.advance_to(now_ns);
  ticks_.time_ns.push_back(now_ns);
  ticks_.poses.push_back(log_.pose.poses[pose_.newest()]);
  add_footing(starts_segment);
  const bool stale = pose_.age_ns(now_ns) > hold_ns_ || tactile_.age_ns(now_ns) > hold_ns_;
  ticks_.stale.push_back(stale ? 1 : 0);
  ticks_.segment_start.push_back(starts_segment ? 1 : 0);
  const bool commanded = control_.passed() > 0;
  ticks_.speed_cmd_mps.push_back(commanded ? log_.control.speed_cmd_mps[control_.newest()]
                                           : kMissing);
  ticks_.yaw_rate_cmd_rps.push_back(commanded ? log_.control.yaw_rate_cmd_rps[control_.newest()]
                                              : kMissing);
  add_readings(now_ns);
  return ticks_[ticks_.size() - 1];
}

// A step that one sample felt must not fall between two ticks.
void Resampler::add_footing(bool starts_segment) {
  if (log_.pose.footing.empty()) {
    return;
  }
  const std::size_t newest = pose_.newest();
  Footing worst = log_.pose.footing[newest];
  if (last_pose_ && !starts_segment) {
    for (std::size_t i = pose_.before(newest); i != StreamPosition::kNone && i > *last_pose_;
         i = pose_.before(i)) {
      keep_worst(log_.pose.footing[i], worst);
    }
  }
  last_pose_ = newest;
  ticks_.footing.push_back(worst);
}

std::int64_t Resampler::skip_silence(std::int64_t tick_ns, std::int64_t period_ns) const {
  const std::int64_t since = std::min(pose_.age_ns(tick_ns), tactile_.age_ns(tick_ns));
  const std::int64_t resumes = std::min(pose_.next_ns(), tactile_.next_ns());
  if (since <= kLongestSilenceNs || resumes <= tick_ns) {
    return tick_ns;
  }
  return tick_ns + (resumes - tick_ns) / period_ns * period_ns;
}

// Samples before a break are not mixed with those after it.
bool Resampler::pass_breaks(std::int64_t now_ns) noexcept {
  bool any = false;
  while (next_break_ < log_.breaks_ns.size() && log_.breaks_ns[next_break_] <= now_ns) {
    segment_begin_ = tactile_.made_before(log_.breaks_ns[next_break_]);
    ++next_break_;
    any = true;
  }
  return any;
}

// The newest samples of each ray that hold a value: rays of a tactile.csv may have rates of their
// own, with empty cells between. The last rows count whatever their age, older ones only while
// they would not make a tick stale.
void Resampler::add_readings(std::int64_t now_ns) {
  if (tactile_.passed() == 0) {
    ticks_.readings.resize(ticks_.readings.size() + log_.tactile.rays);
    return;
  }
  // The newest sample counts even if it is older than the break: its tick is then stale.
  const std::size_t segment = std::min(segment_begin_, tactile_.newest());
  const std::size_t rays = log_.tactile.rays;
  for (std::size_t k = 0; k < rays; ++k) {
    MedianWindow value;
    MedianWindow force;
    std::size_t seen = 0;
    for (std::size_t sample = tactile_.newest(); sample != StreamPosition::kNone;
         sample = tactile_.before(sample)) {
      const bool counts =
          seen++ < median_samples_ || now_ns - log_.tactile.time_ns[sample] <= hold_ns_;
      if (sample < segment || !counts ||
          (value.size() == median_samples_ && force.size() == median_samples_)) {
        break;
      }
      const RayReading& reading = log_.tactile.readings[sample * rays + k];
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

}  // namespace tcert
