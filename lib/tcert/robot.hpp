#pragma once
/// \file
/// The agent A of the paper (body and turning limit), the course, and the rays that feel the walls.

#include <cmath>
#include <optional>
#include <string>
#include <tcert/geometry.hpp>
#include <tcert/parameter_fields.hpp>
#include <tcert/region.hpp>
#include <vector>

namespace tcert {

/// Monotone piecewise-linear map h_clr from a tentacle's bend to clearance (paper 3.1, P1).
/// Outside the knots it keeps the value of the nearest knot.
struct Calibration {
  std::vector<double> bend_rad;     ///< Strictly increasing.
  std::vector<double> clearance_m;  ///< Monotone, same length as bend_rad.
};

enum class RayKind {
  bend,   ///< A tentacle: its reading is a bend angle, read through the calibration.
  range,  ///< A beam: its reading is the clearance itself.
};

/// One direction in which clearance is felt. Its mount is fixed to the body, and so is its bearing,
/// unless a joint moves it: then each reading states its own (RayReading::bearing_rad).
struct Ray {
  std::string name;
  Point mount;               ///< In the body frame, x forward and y left.
  double bearing_rad = 0.0;  ///< From the heading, counter-clockwise.
  double reach_m = 0.0;      ///< Longest clearance that the ray can state; > 0.
  RayKind kind = RayKind::range;
  Calibration calibration;  ///< Used by bend rays only.
};

/// The body half-width r_B is half of body_width_m. See parameters/robot.def.
struct Robot {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/robot.def>
  std::vector<Ray> rays;
};

/// See parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const Robot& /*list*/, Visit&& visit) {
  using Group = Robot;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/robot.def>
}

/// Access and egress regions. Without a start, S is the disc of half the body width round the
/// first node; without a goal there is no certificate T_t, only the on-policy corridor value V_t.
struct Course {
  std::optional<Region> start;
  std::optional<Region> goal;
};

/// The largest bearing, in rad: a little more than a turn.
inline constexpr double kLargestBearing = 6.3;

/// False of a reading that states a bearing which is none; NaN states none. Nobody knows what such a
/// reading felt.
[[nodiscard]] inline bool is_usable_bearing(double stated_rad) noexcept {
  return !(std::abs(stated_rad) > kLargestBearing);
}

/// The bearing of a ray at a reading: that of the reading if it states one, else the ray's own.
[[nodiscard]] inline double bearing_of(const Ray& ray, double stated_rad) noexcept {
  return std::abs(stated_rad) <= kLargestBearing ? stated_rad : ray.bearing_rad;
}

/// h_clr(bend). O(log knots). \pre the calibration has at least one knot.
[[nodiscard]] double calibrated_clearance(const Calibration& calibration, double bend_rad) noexcept;

/// Inverse of h_clr where it is strictly monotone: the smallest bend that reads as `clearance_m`.
[[nodiscard]] double calibrated_bend(const Calibration& calibration, double clearance_m) noexcept;

/// The longest clearance that a ray can state, in metres: its reach, or where a calibration ends
/// short of it, the end of that; beyond it nothing is ever read, so nothing may wait for it. O(1).
/// \pre the calibration of a bend is monotone, with at least one knot.
[[nodiscard]] double longest_clearance(const Ray& ray) noexcept;

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const Robot& robot);

/// \throws std::invalid_argument unless regions are finite, discs have a radius above 0, polygons
/// have at least three vertices, and S and G no point in common.
void validate(const Course& course);

}  // namespace tcert
