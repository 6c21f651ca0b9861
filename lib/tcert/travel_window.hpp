#pragma once
/// \file
/// Quantities over the last so many metres of travel. Travel advances in steps of at least the
/// dead band, so a window holds a bounded number of distinct travels and needs a bounded memory.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tcert/lengths.hpp>
#include <vector>

namespace tcert {

/// A queue in a ring of fixed size; the oldest entry is dropped if it is full.
template <typename Entry>
class TravelQueue {
 public:
  /// Room for `window_m` of travel counted in steps of at least `step_m` > 0.
  TravelQueue(double window_m, double step_m)
      : entries_(static_cast<std::size_t>(window_m / step_m) + 3) {}

  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] const Entry& front() const noexcept { return entries_[first_]; }
  [[nodiscard]] const Entry& back() const noexcept { return entries_[at(size_ - 1)]; }
  void clear() noexcept { size_ = 0; }
  void pop_back() noexcept { --size_; }
  void pop_front() noexcept {
    first_ = at(1);
    --size_;
  }
  void push_back(const Entry& entry) noexcept {
    if (size_ == entries_.size()) {
      pop_front();
    }
    entries_[at(size_)] = entry;
    ++size_;
  }

 private:
  [[nodiscard]] std::size_t at(std::size_t i) const noexcept {
    const std::size_t slot = first_ + i;
    return slot < entries_.size() ? slot : slot - entries_.size();
  }

  std::vector<Entry> entries_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// Smallest value added over the last `window_m` of travel. Amortised O(1) an addition.
class TrailingMinimum {
 public:
  TrailingMinimum(double window_m, double step_m) : window_m_(window_m), queue_(window_m, step_m) {}

  void clear() noexcept { queue_.clear(); }

  /// Returns the minimum with `value` in it. \pre `travel_m` never falls between two clears.
  double add(double travel_m, double value) noexcept {
    while (!queue_.empty() && queue_.back().value >= value) {
      queue_.pop_back();
    }
    if (queue_.empty() || queue_.back().travel_m < travel_m) {
      queue_.push_back({travel_m, value});
    }
    while (exceeds(travel_m - queue_.front().travel_m, window_m_)) {
      queue_.pop_front();
    }
    return queue_.front().value;
  }

 private:
  struct Entry {
    double travel_m = 0.0;
    double value = 0.0;
  };
  double window_m_;
  TravelQueue<Entry> queue_;
};

/// The same where values lose worth with time, by `lost` since it began: the least value of a place
/// holds as of the newest there, so that it is never above that of TrailingMinimum. A place is one
/// travel and, for who turns on the spot looks elsewhere, about one heading.
class TrailingAged {
 public:
  TrailingAged(double window_m, double step_m) : before_(window_m, step_m) {}

  void clear() noexcept {
    before_.clear();
    has_place_ = false;
  }

  /// Returns the minimum with `value` in it, as it holds now. \pre `travel_m` and `lost` never fall
  /// between two clears.
  double add(double travel_m, double yaw_rad, double value, double lost) noexcept {
    constexpr double kSameHeading = 0.05;  // rad
    const bool is_same =
        has_place_ && travel_m == place_m_ && std::abs(yaw_rad - yaw_rad_) <= kSameHeading;
    if (is_same) {
      least_ = std::min(least_, value);
    } else {
      if (has_place_) {
        before_.add(place_m_, worth_at_first_);
      }
      has_place_ = true;
      place_m_ = travel_m;
      yaw_rad_ = yaw_rad;
      least_ = value;
      // What has left the window goes; infinity is no value.
      least_before_ = before_.add(travel_m, std::numeric_limits<double>::infinity());
    }
    worth_at_first_ = least_ + lost;
    return std::min(least_before_, worth_at_first_) - lost;
  }

 private:
  TrailingMinimum before_;  // of what each place was worth when nothing was lost yet
  double least_before_ = 0.0;
  bool has_place_ = false;
  double place_m_ = 0.0;
  double yaw_rad_ = 0.0;
  double least_ = 0.0;
  double worth_at_first_ = 0.0;
};

/// Net change of an unwrapped heading, and of the way across the heading, over the last `window_m`
/// of travel.
class TrailingMotion {
 public:
  TrailingMotion(double window_m, double step_m) : window_m_(window_m), queue_(window_m, step_m) {}

  struct Motion {
    double travel_m = 0.0;
    double yaw_rad = 0.0;
    double across_m = 0.0;  ///< Sum over steps, whichever way.
  };

  void clear() noexcept { queue_.clear(); }

  /// \pre `travel_m` never falls between two clears.
  Motion add(const Motion& now) noexcept {
    if (queue_.empty() || queue_.back().travel_m < now.travel_m) {
      queue_.push_back(now);
    }
    while (exceeds(now.travel_m - queue_.front().travel_m, window_m_)) {
      queue_.pop_front();
    }
    const Motion& then = queue_.front();
    return {now.travel_m - then.travel_m, now.yaw_rad - then.yaw_rad, now.across_m - then.across_m};
  }

 private:
  double window_m_;
  TravelQueue<Motion> queue_;
};

}  // namespace tcert
