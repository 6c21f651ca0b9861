#pragma once
/// \file
/// The barrier of the points that were felt (paper 2.2, 7-1): as rows for the filter, and as the
/// filtered command of a body at a pose.

#include <array>
#include <span>
#include <tcert/barrier_filter.hpp>
#include <tcert/felt_points.hpp>
#include <tcert/geometry.hpp>
#include <tcert/speed_law.hpp>

namespace tcert {

/// h of one felt point: how far the disc of the body, put round the point p that lies
/// barrier_point_m ahead of its middle and widened by as much, is from it.
struct BarrierRows {
  std::array<BarrierRow, FeltPoints::kNearest> rows{};
  std::array<double, FeltPoints::kNearest> slack_m{};  ///< h of each.
  std::size_t count = 0;
  double front_m = 0.0;  ///< Least h of those that lie in the way straight ahead; infinite if none.
};

/// For each point q, with n the unit vector from p to q and u the heading:
/// (n.u) v + l (n.u_perp) w <= alpha h. p moves with the yaw as well, which makes the steering
/// count.
[[nodiscard]] BarrierRows barrier_rows(const FeltPoints::Nearest& felt,
                                       const Pose& pose,
                                       double half_width_m,
                                       const SpeedLaw& law) noexcept;

/// The command nearest to `wanted` that keeps every row, at no more than the speed from which the
/// body stops short of what lies ahead: v <= sqrt(2 brake max(h_front, 0)). Reversing is left as it
/// is. The discrete condition h(x') >= (1 - alpha dt) h(x), with x' after `period_s` on the arc
/// that is really driven, is checked at the result: while it fails, the command is made smaller by
/// an eighth, sixteen times at most, and then halts. Infeasible: halts, and says so.
[[nodiscard]] FilteredCommand barrier_command(const Command& wanted,
                                              const FeltPoints& felt,
                                              const Pose& pose,
                                              double half_width_m,
                                              double period_s,
                                              const SpeedLaw& law) noexcept;

}  // namespace tcert
