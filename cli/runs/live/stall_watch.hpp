#pragma once
/// \file
/// Notices a producer that stalls.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "cli/runs/live/patient_output.hpp"

namespace tcert::cli {

/// Says when ticks have stopped coming, and when they come again.
class StallWatch {
 public:
  StallWatch(double after_s, StatusLines& status) : after_(after_s), status_(status) {}

  void tick() {
    const Clock::time_point now = Clock::now();
    if (stalled_) {
      status_.say("tcert live: ticks again, after " + seconds(now - last_) + " s");
    }
    stalled_ = false;
    last_ = now;
  }

  void look() {
    if (!stalled_ && after_.count() > 0.0 && Clock::now() - last_ >= after_) {
      stalled_ = true;
      status_.say("tcert live: stale: no tick for " + seconds(Clock::now() - last_) +
                  " s, the last row is no longer current");
    }
  }

  /// For poll: -1 if there is nothing to wait for.
  [[nodiscard]] int left_ms() const {
    if (stalled_ || !(after_.count() > 0.0)) {
      return -1;
    }
    const Seconds left = after_ - (Clock::now() - last_);
    return static_cast<int>(std::clamp(std::ceil(1000.0 * left.count()), 0.0, 1e6));
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  static std::string seconds(Seconds span) {
    return std::to_string(static_cast<int>(span.count())) + '.' +
           std::to_string(static_cast<int>(10.0 * span.count()) % 10);
  }

  Seconds after_;
  StatusLines& status_;
  Clock::time_point last_ = Clock::now();
  bool stalled_ = false;
};

}  // namespace tcert::cli
