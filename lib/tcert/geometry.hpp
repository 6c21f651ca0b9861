#pragma once
/// \file
/// Points, poses and angles in the plane. Metres and radians; yaw counter-clockwise from +x.

#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

namespace tcert {

struct Point {
  double x_m = 0.0;
  double y_m = 0.0;
  friend bool operator==(const Point&, const Point&) = default;
};

struct Pose {
  Point position;
  double yaw_rad = 0.0;
};

[[nodiscard]] constexpr Point operator+(Point a, Point b) noexcept {
  return {a.x_m + b.x_m, a.y_m + b.y_m};
}
[[nodiscard]] constexpr Point operator-(Point a, Point b) noexcept {
  return {a.x_m - b.x_m, a.y_m - b.y_m};
}
[[nodiscard]] constexpr Point operator*(double s, Point a) noexcept {
  return {s * a.x_m, s * a.y_m};
}
[[nodiscard]] constexpr double dot(Point a, Point b) noexcept {
  return a.x_m * b.x_m + a.y_m * b.y_m;
}
/// Positive if `b` lies to the left of `a`.
[[nodiscard]] constexpr double cross(Point a, Point b) noexcept {
  return a.x_m * b.y_m - a.y_m * b.x_m;
}
[[nodiscard]] inline double norm(Point a) noexcept { return std::sqrt(dot(a, a)); }
[[nodiscard]] inline double distance(Point a, Point b) noexcept { return norm(a - b); }

/// Unit vector of a yaw.
[[nodiscard]] inline Point direction(double yaw_rad) noexcept {
  const auto [sine, cosine] = elementary::sine_cosine(yaw_rad);
  return {cosine, sine};
}

/// The angle in [-pi, pi], as std::remainder(angle_rad, 2 pi) to the bit; within three half-turns,
/// where nearly all angles are, one subtraction gives it exactly (Sterbenz).
[[nodiscard]] inline double wrapped_angle(double angle_rad) noexcept {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double size_rad = std::abs(angle_rad);
  if (size_rad <= 0.5 * kTurn) {
    return angle_rad;
  }
  if (size_rad < 1.5 * kTurn) {
    const double rest_rad = size_rad - kTurn;
    return angle_rad < 0.0 ? -rest_rad : rest_rad;
  }
  return std::remainder(angle_rad, kTurn);
}

/// Signed difference of two angles in [-pi, pi]; exactly antisymmetric in its arguments.
[[nodiscard]] inline double angle_between(double from_rad, double to_rad) noexcept {
  return wrapped_angle(to_rad - from_rad);
}

/// `local`, given in the frame of `pose`, in the frame that `pose` is given in.
[[nodiscard]] inline Point transform(const Pose& pose, Point local) noexcept {
  const Point u = direction(pose.yaw_rad);
  return {pose.position.x_m + u.x_m * local.x_m - u.y_m * local.y_m,
          pose.position.y_m + u.y_m * local.x_m + u.x_m * local.y_m};
}

}  // namespace tcert
