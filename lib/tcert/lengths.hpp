#pragma once
/// \file
/// Comparisons of a length with a limit that do not hang on the last bits: a log in which the robot
/// moves by exactly the dead band gives the same result in every frame.

namespace tcert {

/// Lengths that differ by less, relative to the limit, are equal: far above rounding, far below
/// anything that is measured.
inline constexpr double kEqualLengths = 1e-9;

[[nodiscard]] constexpr bool exceeds(double length_m, double limit_m) noexcept {
  return length_m > limit_m * (1.0 + kEqualLengths);
}

[[nodiscard]] constexpr bool reaches(double length_m, double limit_m) noexcept {
  return length_m >= limit_m * (1.0 - kEqualLengths);
}

}  // namespace tcert
