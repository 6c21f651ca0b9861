#pragma once
/// \file
/// Arithmetic by which the mirror image of what a robot feels gives the mirror image of what it
/// does, to the last bit: the plane is mirrored about the x axis of the odometry, left and right
/// change places.
///
/// Negation is exact and a + b is b + a, so that most of it comes by itself. Three things do not:
/// a sine at a tie of its reduction, a sum whose terms come in another order, and a choice between
/// two that are each other's image. They have their answers here and in every `side` below, the
/// side (+1 left, -1 right) that wins a tie: what the robot last had a reason to turn to.

#include <cmath>
#include <numbers>
#include <tcert/geometry.hpp>

namespace tcert::policies {

/// Unit vector of an angle; of -a the exact mirror image of that of a. Half a turn, either way, is
/// straight back, which is its own image.
[[nodiscard]] inline Point unit(double angle_rad) noexcept {
  const double turn = std::abs(angle_rad);
  if (turn == std::numbers::pi) {
    return {-1.0, 0.0};
  }
  const Point u = direction(turn);
  return {u.x_m, angle_rad < 0.0 ? -u.y_m : u.y_m};
}

/// The nearest multiple of 2^-40. Sums of such terms are exact, hence the same in any order, while
/// they stay below 2^13. \pre |term| < 2^12.
[[nodiscard]] inline double exact_term(double term) noexcept {
  constexpr double kUnit = 0x1p40;
  return std::round(term * kUnit) / kUnit;
}

/// The frame of the body: x along the heading, y to the left.
struct BodyFrame {
  Point origin;
  Point ahead{1.0, 0.0};  ///< Unit vector of the heading.

  [[nodiscard]] static BodyFrame of(const Pose& pose) noexcept {
    return {pose.position, unit(pose.yaw_rad)};
  }
  /// A direction given in the body, in the odometry.
  [[nodiscard]] Point turned(Point local) const noexcept {
    return {ahead.x_m * local.x_m - ahead.y_m * local.y_m,
            ahead.x_m * local.y_m + ahead.y_m * local.x_m};
  }
  [[nodiscard]] Point to_odometry(Point local) const noexcept { return origin + turned(local); }
  [[nodiscard]] Point to_body(Point p) const noexcept {
    const Point d = p - origin;
    return {dot(ahead, d), cross(ahead, d)};
  }
};

/// Bearing of a point of the body frame, in [-pi, pi].
[[nodiscard]] inline double bearing_of(Point local) noexcept {
  return elementary::atan2(local.y_m, local.x_m);
}

/// +1, -1 or 0.
[[nodiscard]] constexpr int sign_of(double x) noexcept { return x > 0.0 ? 1 : x < 0.0 ? -1 : 0; }

}  // namespace tcert::policies
