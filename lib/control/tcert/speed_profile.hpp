#pragma once
/// \file
/// The fastest speeds along a way whose speed is limited, for a body that gains and loses speed at
/// limited rates (paper 7-1). The geometry is fixed, so that the problem has one dimension, and a
/// pass forwards and one backwards solve it exactly; no quadratic program is needed.

#include <span>
#include <tcert/speed_law.hpp>

namespace tcert {

/// Lowers `speeds_mps`, on entry the limits v_max(s_k) at places `step_m` apart, to the largest
/// profile with v_0 = min(limit, now_mps), v_{k+1}^2 <= v_k^2 + 2 accel step (forwards) and
/// v_k^2 <= v_{k+1}^2 + 2 brake step (backwards). It is the largest at every place at once, hence
/// the fastest in time. Where the limits ahead ask for more than `brake`, v_0 is what they leave,
/// which is below now_mps. O(places). \pre limits >= 0, step_m, accel, brake > 0.
void limit_profile(std::span<double> speeds_mps,
                   double step_m,
                   double now_mps,
                   double accel_mps2,
                   double brake_mps2) noexcept;

/// The speed for the next `period_s` under the profile law: the limit is `limit_mps` as far as the
/// way ahead is explored, `front_m`, and the law's least speed beyond it, where 0 would stop an
/// exploring robot for good. What the robot may reach in the period is what it can brake from
/// afterwards. Never below min(least speed, limit).
[[nodiscard]] double profile_speed(const SpeedLaw& law,
                                   double limit_mps,
                                   double front_m,
                                   double last_mps,
                                   double period_s) noexcept;

}  // namespace tcert
