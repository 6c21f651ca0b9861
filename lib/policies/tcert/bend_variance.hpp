#pragma once
/// \file
/// How rough each ray has felt the way to be: the variance of its bend over the last travel.

#include <cstdint>
#include <span>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <tcert/travel_window.hpp>
#include <vector>

namespace tcert::policies {

/// Population variance of each ray's bend over a window of travel, one sample each step of travel.
/// Rays of another kind have no bend, and no variance; nor has one with fewer than two samples.
/// Bends count in whole 2^-18 rad, up to 8 rad: sums are exact, so that what leaves the window
/// leaves nothing behind.
///
/// The constructor takes all memory; every other member is noexcept.
class BendVariance {
 public:
  /// \pre window_m at most 1000 steps of step_m > 0.
  BendVariance(const Robot& robot, double window_m, double step_m);

  void reset() noexcept;

  /// \pre `travel_m` never falls between two resets.
  void add(double travel_m, std::span<const RayReading> readings) noexcept;

  /// In rad^2, by ray; NaN where there is none.
  [[nodiscard]] std::span<const double> rad2() const noexcept { return rad2_; }

 private:
  struct Sample {
    double travel_m = 0.0;
    std::int64_t bend = 0;
  };
  struct Window {
    explicit Window(double window_m, double step_m) : samples(window_m, step_m) {}
    TravelQueue<Sample> samples;
    std::int64_t count = 0;
    std::int64_t sum = 0;
    std::int64_t square_sum = 0;
  };
  static void count(Window& window, std::int64_t bend, std::int64_t sign) noexcept;
  void drop_old(Window& window, double travel_m) const noexcept;

  double window_m_;
  double step_m_;
  std::vector<bool> bends_;  // by ray
  std::vector<Window> windows_;
  std::vector<double> rad2_;
};

}  // namespace tcert::policies
