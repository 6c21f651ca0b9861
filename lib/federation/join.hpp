#pragma once
/// \file
/// The way from a node of one robot to a node of another.

#include <federation/submap.hpp>

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

/// A lower bound of the margin of the way from `from` to wherever `to` may truly be, in the width
/// convention:
///
///     min(m_u, m_v, (m_u + m_v) / 2 - D, 1 / (kappa + epsilon_kappa) - R_min)
///
/// D is the way's length with the error of the frames: clearance falls by at most 1 a metre, so
/// that at s from u a disc of m_u / 2 - s is free, and at D - s from v one of m_v / 2 - (D - s).
/// kappa is the curvature that a change from the one lane to the other asks for, join_curvature(),
/// the largest for any place that `to` may have. Ends of the same pose without error are one place:
/// D = 0 and nothing to turn. -infinity if `to` does not lie ahead, or may not.
[[nodiscard]] double join_margin(const JoinEnd& from,
                                 const JoinEnd& to,
                                 const FrameError& error,
                                 const Agent& agent) noexcept;

}  // namespace tcert::federation
