#pragma once
/// \file
/// Streams into ticks, one instant after the other, while the streams may still grow.

#include <cstddef>
#include <cstdint>
#include <tcert/tick.hpp>
#include <utility>
#include <vector>

#include "datasets/ticks.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

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

/// One forward pass over the streams of a trial, which may be longer at each tick than at the last,
/// as while they are being logged: a tick depends on the samples up to its instant alone.
class Resampler {
 public:
  /// `log` outlives it and changes only by samples at the ends of its streams. \pre `options` are
  /// valid, and no row of the tactile stream is empty.
  Resampler(const TrialLog& log, const ResampleOptions& options);

  /// Appends the tick at an instant and hands it back; its readings are valid until the next.
  /// \pre `now_ns` rises, and the pose has a sample by then.
  Tick add_tick(std::int64_t now_ns);

  /// Where the next tick may be: after a silence of both streams longer than a minute the grid is
  /// taken up again at the next sample, so that a wrong clock cannot ask for any number of ticks.
  [[nodiscard]] std::int64_t skip_silence(std::int64_t tick_ns, std::int64_t period_ns) const;

  [[nodiscard]] const TickTable& ticks() const noexcept { return ticks_; }
  [[nodiscard]] TickTable take() { return std::move(ticks_); }

 private:
  /// True if the path breaks between the last tick and this one.
  [[nodiscard]] bool pass_breaks(std::int64_t now_ns) noexcept;
  void add_readings(std::int64_t now_ns);

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

}  // namespace tcert
