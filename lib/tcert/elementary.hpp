#pragma once
/// \file
/// Elementary functions of one arithmetic: the same bits on every processor, by every compiler and
/// C library. A C library may choose its exp or sin at run time by what the processor offers, and
/// the choices differ in the last digit. These are made of +, -, *, /, floor and sqrt, which IEEE
/// 754 rounds exactly, and are compiled without fused multiply-adds.
///
/// Largest error of 10^6 values a range against quadruple precision, in units in the last place:
/// exp 0.89, exp2 1.04, log 0.81, sin and cos 0.96, atan2 0.76, acos 1.6, tan 2.2, asin 2.2.

namespace tcert::elementary {

/// e to the power x. Infinity above 709.79, 0 below -745.14, NaN of NaN; gradual underflow.
[[nodiscard]] double exp(double x) noexcept;

/// 2 to the power x. Infinity from 1024 on, 0 below -1075, NaN of NaN; gradual underflow.
[[nodiscard]] double exp2(double x) noexcept;

/// Natural logarithm: -infinity of 0, NaN of what is below 0.
[[nodiscard]] double log(double x) noexcept;

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle in radians; NaN unless it is finite. Beyond 10^5 rad the angle is
/// first taken modulo the double nearest to 2 pi, an error below the rounding of the angle itself.
[[nodiscard]] SineCosine sine_cosine(double angle_rad) noexcept;

[[nodiscard]] inline double sin(double angle_rad) noexcept { return sine_cosine(angle_rad).sine; }
[[nodiscard]] inline double cos(double angle_rad) noexcept { return sine_cosine(angle_rad).cosine; }
[[nodiscard]] double tan(double angle_rad) noexcept;

/// Angle of the point (x, y) from the x axis, in [-pi, pi]; 0 at the origin, whatever the sign of
/// its zeros; NaN of NaN. \pre neither is infinite.
[[nodiscard]] double atan2(double y, double x) noexcept;

/// NaN unless |x| <= 1.
[[nodiscard]] double asin(double x) noexcept;
[[nodiscard]] double acos(double x) noexcept;

}  // namespace tcert::elementary
