#pragma once
/// \file
/// Closed form of a tracking-error bound: a double integrator per axis that follows a planner
/// (FaSTrack: Herbert et al., CDC 2017; Chen et al., IEEE TAC 2021).

namespace tcert {

/// What tracks the path. The planner's point moves at a speed v, and strays from the path at most
/// at `exploring_mps`; the robot brakes with `braking_mps2`, of which a disturbance takes
/// `disturbance_mps2`, and is pushed by it at `disturbance_mps`.
struct DoubleIntegrator {
  double braking_mps2 = 1.0;
  double disturbance_mps2 = 0.0;
  double disturbance_mps = 0.0;
  double exploring_mps = 0.0;
};

/// r(v) = (v + d_v)^2 / (a - d_a) + v_exp (2 v + v_exp / 2) / (a - d_a), in metres: convex and
/// rising in the speed and in the disturbance, so that linear interpolation between knots is never
/// below it. +infinity unless a > d_a, and of a speed that is negative or NaN.
[[nodiscard]] double tracking_radius_m(const DoubleIntegrator& model, double speed_mps) noexcept;

/// (v_left + d_v) / (a - d_a), in seconds: how long r(v_left) goes on holding after a change to a
/// smaller speed. +infinity likewise.
[[nodiscard]] double tracking_hold_s(const DoubleIntegrator& model, double speed_left_mps) noexcept;

}  // namespace tcert
