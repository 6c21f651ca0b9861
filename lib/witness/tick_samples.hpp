#pragma once
/// \file
/// Samples from ticks as they come.

#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <witness/samples.hpp>

namespace tcert::witness {

/// Of a robot that outlives it.
class TickSamples {
 public:
  explicit TickSamples(const Robot& robot) : robot_(robot) { samples_.rays = robot.rays.size(); }

  /// A stale tick, or one whose pose cannot be used, is none; a break before it is kept for the
  /// next. \pre later than those before, a reading a ray. O(rays).
  void add(const Tick& tick);

  [[nodiscard]] const Samples& samples() const noexcept { return samples_; }

 private:
  const Robot& robot_;
  Samples samples_;
  bool is_after_break_ = true;
};

}  // namespace tcert::witness
