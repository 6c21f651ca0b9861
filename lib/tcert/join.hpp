#pragma once
/// \file
/// What it takes to pass from the path that is being driven to a known node beside it.

#include <cmath>
#include <tcert/elementary.hpp>

namespace tcert {

/// Curvature, 1/m, that a path needs to change over from a straight lane to another that crosses
/// the same line `offset_m` further to the side and `off_axis_rad` off its heading, within
/// `length_m` before the line and `length_m` after it.
///
/// Along the node's heading the change y(x) has y = y' = 0 at one end, and y' = s = tan(off axis)
/// at the other, 2 l away, where y = offset +- l s. The least possible largest |y''| is that of two
/// parabolas, (|d| + sqrt(d^2 + (l s)^2)) / (2 l^2); the curvature of y(x) is never above |y''|.
[[nodiscard]] inline double join_curvature(double offset_m,
                                           double off_axis_rad,
                                           double length_m) noexcept {
  const auto [sine, cosine] = elementary::sine_cosine(off_axis_rad);
  const double rise_m = length_m * sine / cosine;
  return (std::abs(offset_m) + std::sqrt(offset_m * offset_m + rise_m * rise_m)) /
         (2.0 * length_m * length_m);
}

}  // namespace tcert
