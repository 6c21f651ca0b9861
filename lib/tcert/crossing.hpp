#pragma once
/// \file
/// Where the path passes a known node, and what it takes to change over from the one to the other.

#include <cstdint>
#include <limits>
#include <tcert/corridor_graph.hpp>
#include <tcert/parameters.hpp>
#include <tcert/pending_pass.hpp>
#include <tcert/robot.hpp>

namespace tcert {

/// Curvature, 1/m, that a path needs to change over from a straight lane to another that crosses
/// the same line `offset_m` further to the side and `off_axis_rad` off its heading, within
/// `length_m` before the line and `length_m` after it.
///
/// Along the node's heading the change y(x) has y = y' = 0 at one end, and y' = s = tan(off axis)
/// at the other, 2 l away, where y = offset +- l s. The least possible largest |y''| is that of two
/// parabolas, (|d| + sqrt(d^2 + (l s)^2)) / (2 l^2); the curvature of y(x) is never above |y''|.
[[nodiscard]] double join_curvature(double offset_m, double off_axis_rad, double length_m) noexcept;

/// When a pass closes at a known node, and what the change is charged.
struct CrossingRule {
  CrossingRule(const Robot& robot, const CertificateParameters& parameters) noexcept;

  double merge_radius_m;
  double merge_angle_rad;
  double length_m;  ///< Before and after the node's line, on which the change is made.
  double half_body_m;
  double min_turn_radius_m;
  double curvature_buffer_per_m;
  bool charges_turns;  ///< Ablation A3 does not.
};

/// The turn that a change from one pass to another asks for.
struct Turn {
  double slack_m = std::numeric_limits<double>::infinity();  ///< Over R_min.
  double turn_radius_m = 0.0;
  Pose pose;
};

/// Which side of a node the motion enters by; no node: it does not cross.
struct Crossing {
  std::uint32_t node = kNone;
  Side entered = Side::back;
  double distance2 = 0.0;  ///< From the node, in m^2.
  Point at;
  Turn turn;
};

/// The last step of the path, and the pass that it belongs to.
struct PathStep {
  const Evidence& before;
  const Evidence& now;
  const PendingPass& pass;
};

/// The path crosses the line through the node, perpendicular to its heading, near the node and
/// along its heading. Near is within half a body, where the bodies of both passes cover what lies
/// between them, or as far as the body fits in what was felt on that side all along the pass; at
/// most the merge radius.
[[nodiscard]] Crossing crossing_of(const CorridorGraph& graph,
                                   std::uint32_t node,
                                   const PathStep& step,
                                   const CrossingRule& rule) noexcept;

/// Of the known nodes but `except`, the nearest to where the path crosses it; ties: lowest index.
[[nodiscard]] Crossing nearest_crossing(const CorridorGraph& graph,
                                        std::uint32_t except,
                                        const PathStep& step,
                                        const CrossingRule& rule) noexcept;

}  // namespace tcert
