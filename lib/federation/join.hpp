#pragma once
/// \file
/// The way from a node of one robot to a node of another.

#include <federation/submap.hpp>
#include <optional>

namespace tcert::federation {

/// Where a way begins or ends: the pose that it has there, the heading along the way, and a lower
/// bound of the margin of standing there.
struct JoinEnd {
  Pose pose;
  double margin_m = 0.0;
};

/// By how much the second end may be off against the first.
struct FrameError {
  double position_m = 0.0;
  double heading_rad = 0.0;
};

/// Ends whose headings differ by more are not joined.
inline constexpr double kSharpestJoin = 1.0471975511965976;  // pi / 3

/// The way from one pose to wherever another may truly be, tangent to both.
struct JoinShape {
  double length_m = 0.0;      ///< At most.
  double turn_slack_m = 0.0;  ///< 1 / (kappa + epsilon_kappa) - R_min, at least.
  double bow_m = 0.0;         ///< How far it leaves the straight line between the two, at most.
  double off_m = 0.0;         ///< How far the second end may be from where it is stated.
};

/// kappa is the curvature that a change from the one lane to the other asks for, join_curvature(),
/// the largest for any place that `to` may have. Poses that are equal without error are one place:
/// no length and nothing to turn. None if `to` does not lie ahead, or may not.
[[nodiscard]] std::optional<JoinShape> join_shape(const Pose& from,
                                                  const Pose& to,
                                                  const FrameError& error,
                                                  const Agent& agent) noexcept;

/// A lower bound of the margin of that way, in the width convention:
///
///     min(m_u, m_v, (m_u + m_v) / 2 - D, 1 / (kappa + epsilon_kappa) - R_min)
///
/// D is the way's length with the error of the frames: clearance falls by at most 1 a metre, so
/// that at s from u a disc of m_u / 2 - s is free, and at D - s from v one of m_v / 2 - (D - s).
[[nodiscard]] double join_margin(const JoinEnd& from,
                                 const JoinEnd& to,
                                 const JoinShape& shape) noexcept;

/// An edge's path stays within `spread_m` of the straight line from `a` to `b`.
struct Stretch {
  Point a;
  Point b;
  double margin_m = 0.0;
  double spread_m = 0.0;
};

/// Another, of a way that runs beside an edge that leads on from `from`, then beside one that leads
/// to `to`, or beside one of them alone (the other is null): each place of the way is near to one
/// where an edge's margin holds.
///
///     min(m_e - 2 (away + bow + error + spread) of both, 1 / (kappa + epsilon_kappa) - R_min)
///
/// away: how far the part of the way's straight line beside the edge is from the edge's, at most,
/// which is at an end of the part. Of eight places to change over the best is taken.
[[nodiscard]] double margin_beside(const Pose& from,
                                   const Pose& to,
                                   const JoinShape& shape,
                                   const Stretch* ahead,
                                   const Stretch* behind) noexcept;

}  // namespace tcert::federation
