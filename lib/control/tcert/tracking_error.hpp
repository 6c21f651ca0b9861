#pragma once
/// \file
/// Tracking-error bound r_TE of a robot (paper 5): how far it may stray from its planned path.

#include <array>
#include <cstddef>
#include <vector>

namespace tcert {

/// Radii on a full grid of speed, a second axis and disturbance. `radius_m` is row-major, the
/// disturbance running fastest. The second axis is the size of the change of speed or, where that
/// list is empty, the speed just left: an error that a faster motion has left goes on holding for
/// hold_s after a change to a slower one (FaSTrack's switch between planners).
struct TrackingErrorGrid {
  std::vector<double> speed_mps;
  std::vector<double> acceleration_mps2;  ///< Size of the change of speed; empty: speed_left_mps.
  std::vector<double> disturbance;        ///< Level of wind, slope or load; the robot's own scale.
  std::vector<double> radius_m;
  std::vector<double> speed_left_mps{};  ///< The largest speed that still counts.
  std::vector<double> hold_s{};          ///< For how long each of them counts; never falls.
};

/// A declared grid, for a robot without a measured one: the way of one 20 ms control loop at that
/// speed plus a t^2 / 2 of one 0.1 s tick, doubled at disturbance 1. Up to 0.5 m/s and 5 m/s^2.
[[nodiscard]] TrackingErrorGrid declared_tracking_error();

/// Trilinear look-up. The constructor takes all memory; `radius_m` is noexcept and allocates
/// nothing.
class TrackingErrorTable {
 public:
  /// \throws std::invalid_argument unless every axis is finite, starts at 0 and rises, the second
  /// is one of both, with a time for each speed left that does not fall, and the radii fill the
  /// grid, are finite, not negative and never fall along an axis.
  explicit TrackingErrorTable(TrackingErrorGrid grid = declared_tracking_error());

  /// Monotone in each argument; `second` is a change of speed, or a speed left. Beyond the grid
  /// there is no bound: +infinity, as for NaN. Between knots it is linear along each axis, which is
  /// never below a radius that is convex there. O(log knots).
  [[nodiscard]] double radius_m(double speed_mps, double second, double disturbance) const noexcept;

  /// The second axis is the speed just left.
  [[nodiscard]] bool has_speed_left() const noexcept { return !grid_.speed_left_mps.empty(); }
  /// For how long a speed counts after it was left; infinite beyond the axis. \pre
  /// has_speed_left().
  [[nodiscard]] double hold_s(double speed_mps) const noexcept;

  /// What it was made from.
  [[nodiscard]] const TrackingErrorGrid& grid() const noexcept { return grid_; }

 private:
  [[nodiscard]] const std::vector<double>& second_axis() const noexcept {
    return has_speed_left() ? grid_.speed_left_mps : grid_.acceleration_mps2;
  }
  [[nodiscard]] double at(std::size_t speed,
                          std::size_t second,
                          std::size_t disturbance) const noexcept;

  TrackingErrorGrid grid_;
};

}  // namespace tcert
