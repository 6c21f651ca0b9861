#pragma once
/// \file
/// Streams into ticks, one instant after the other, while the streams may still grow.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <tcert/tick.hpp>
#include <utility>
#include <vector>

#include "datasets/ticks.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

/// Walks a stream forward: which of its samples are there at an instant. A stream may grow at its
/// end only if it has no arrivals.
class StreamPosition {
 public:
  StreamPosition(const std::vector<std::int64_t>& time_ns,
                 const std::vector<std::int64_t>& arrival_ns);

  void advance_to(std::int64_t now_ns);

  /// How many are there.
  [[nodiscard]] std::size_t passed() const noexcept { return passed_; }

  /// The newest, by its own time, of those that are there. \pre passed() > 0.
  [[nodiscard]] std::size_t newest() const noexcept {
    return by_arrival_.empty() ? passed_ - 1 : *there_.rbegin();
  }

  /// The next older one, or kNone. O(log samples), O(1) of a stream without arrivals.
  [[nodiscard]] std::size_t before(std::size_t sample) const noexcept {
    if (by_arrival_.empty()) {
      return sample - 1;
    }
    const auto at = there_.lower_bound(sample);
    return at == there_.begin() ? kNone : *std::prev(at);
  }

  static constexpr std::size_t kNone = SIZE_MAX;

  /// How many samples of the stream are made before an instant, there or not. O(log samples).
  [[nodiscard]] std::size_t made_before(std::int64_t time_ns) const noexcept;

  /// Of the newest sample; of a stream that has not begun, older than anything.
  [[nodiscard]] std::int64_t age_ns(std::int64_t now_ns) const noexcept {
    return passed_ > 0 ? now_ns - time_ns_[newest()] : INT64_MAX;
  }

  /// When the next sample is there, or the time of the last one if all are.
  [[nodiscard]] std::int64_t next_ns() const noexcept {
    return passed_ == time_ns_.size() ? time_ns_.back()
           : by_arrival_.empty()      ? time_ns_[passed_]
                                      : arrival_ns_[by_arrival_[passed_]];
  }

 private:
  const std::vector<std::int64_t>& time_ns_;
  const std::vector<std::int64_t>& arrival_ns_;
  std::vector<std::size_t> by_arrival_;  // samples in the order in which they arrive
  std::set<std::size_t> there_;          // of those the passed ones, in the order of the stream
  std::size_t passed_ = 0;
};

/// One forward pass over the streams of a trial, which may be longer at each tick than at the last,
/// as while they are being logged: a tick depends on the samples that are there at its instant
/// alone.
class Resampler {
 public:
  /// `log` outlives it and changes only by samples at the ends of its streams. \pre `options` are
  /// valid, and no row of the tactile stream is empty.
  Resampler(const TrialLog& log, const ResampleOptions& options);

  /// Appends the tick at an instant and hands it back; its readings are valid until the next.
  /// \pre `now_ns` rises, and has_begun(now_ns).
  Tick add_tick(std::int64_t now_ns);

  /// True if a pose is there by then, and a touch too unless ticks begin with the pose.
  [[nodiscard]] bool has_begun(std::int64_t now_ns);

  /// Where the next tick may be: after a silence of both streams longer than a minute the grid is
  /// taken up again at the next sample, so that a wrong clock cannot ask for any number of ticks.
  [[nodiscard]] std::int64_t skip_silence(std::int64_t tick_ns, std::int64_t period_ns) const;

  [[nodiscard]] const TickTable& ticks() const noexcept { return ticks_; }
  [[nodiscard]] TickTable take() { return std::move(ticks_); }

 private:
  /// True if the path breaks between the last tick and this one.
  [[nodiscard]] bool pass_breaks(std::int64_t now_ns) noexcept;
  void add_readings(std::int64_t now_ns);
  void add_footing(bool starts_segment);

  const TrialLog& log_;
  std::int64_t hold_ns_;
  std::size_t median_samples_;
  StreamPosition pose_;
  StreamPosition tactile_;
  StreamPosition control_;
  std::size_t next_break_ = 0;
  std::size_t segment_begin_ = 0;
  std::optional<std::size_t> last_pose_;  // of the tick before
  TickTable ticks_;
};

}  // namespace tcert
