#pragma once
/// \file
/// Tracking-error bound r_TE of a robot (paper 5): how far it may stray from its planned path.

#include <array>
#include <cstddef>
#include <vector>

namespace tcert {

/// Radii on a full grid of speed, acceleration and disturbance. `radius_m` is row-major, the
/// disturbance running fastest.
struct TrackingErrorGrid {
  std::vector<double> speed_mps;
  std::vector<double> acceleration_mps2;  ///< Size of the change of speed.
  std::vector<double> disturbance;        ///< Level of wind, slope or load; the robot's own scale.
  std::vector<double> radius_m;
};

/// A declared grid, for a robot without a measured one: the way of one 20 ms control loop at that
/// speed plus a t^2 / 2 of one 0.1 s tick, doubled at disturbance 1. Up to 0.5 m/s and 5 m/s^2.
[[nodiscard]] TrackingErrorGrid declared_tracking_error();

/// Trilinear look-up. The constructor takes all memory; `radius_m` is noexcept and allocates
/// nothing.
class TrackingErrorTable {
 public:
  /// \throws std::invalid_argument unless every axis is finite, starts at 0 and rises, and the
  /// radii fill the grid, are finite, not negative and never fall along an axis.
  explicit TrackingErrorTable(TrackingErrorGrid grid = declared_tracking_error());

  /// Monotone in each argument. Beyond the grid there is no bound: +infinity, as for NaN.
  /// O(log knots).
  [[nodiscard]] double radius_m(double speed_mps,
                                double acceleration_mps2,
                                double disturbance) const noexcept;

  /// What it was made from.
  [[nodiscard]] const TrackingErrorGrid& grid() const noexcept { return grid_; }

 private:
  [[nodiscard]] double at(std::size_t speed,
                          std::size_t acceleration,
                          std::size_t disturbance) const noexcept;

  TrackingErrorGrid grid_;
};

}  // namespace tcert
