#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/crossing.hpp>
#include <tcert/elementary.hpp>
#include <tcert/lengths.hpp>

namespace tcert {

double join_curvature(double offset_m, double off_axis_rad, double length_m) noexcept {
  const auto [sine, cosine] = elementary::sine_cosine(off_axis_rad);
  const double rise_m = length_m * sine / cosine;
  return (std::abs(offset_m) + std::sqrt(offset_m * offset_m + rise_m * rise_m)) /
         (2.0 * length_m * length_m);
}

CrossingRule::CrossingRule(const Robot& robot, const CertificateParameters& parameters) noexcept
    : merge_radius_m(parameters.merge_radius_m),
      merge_angle_rad(parameters.merge_angle_rad),
      length_m(parameters.edge_length_m),
      half_body_m(0.5 * robot.body_width_m),
      min_turn_radius_m(robot.min_turn_radius_m),
      curvature_buffer_per_m(robot.curvature_buffer_per_m),
      charges_turns(parameters.curvature != CurvatureReading::none) {}

Crossing crossing_of(const CorridorGraph& graph,
                     std::uint32_t node,
                     const PathStep& step,
                     const CrossingRule& rule) noexcept {
  const auto& [at, heading, in_start, in_goal] = graph.nodes()[node];
  const Point from = step.before.pose.position;
  const Pose& now = step.now.pose;
  const double before_m = dot(from - at.position, heading);
  const double after_m = dot(now.position - at.position, heading);
  if ((before_m < 0.0) == (after_m < 0.0)) {
    return {};
  }
  const double share = before_m / (before_m - after_m);
  const Point off = from + share * (now.position - from) - at.position;
  const double distance2 = dot(off, off);
  const double aside_m = -dot(off, {-step.now.heading.y_m, step.now.heading.x_m});
  const double felt_m = aside_m > 0.0 ? step.pass.left_m() : step.pass.right_m();
  const double reach_m =
      std::min(rule.merge_radius_m, std::max(rule.half_body_m, felt_m - rule.half_body_m));
  const double turned = std::abs(angle_between(at.yaw_rad, now.yaw_rad));
  const double off_axis = std::min(turned, std::numbers::pi - turned);
  if (exceeds(std::sqrt(distance2), reach_m) || exceeds(off_axis, rule.merge_angle_rad)) {
    return {};
  }
  Crossing found{node, before_m < 0.0 ? Side::back : Side::front, distance2, at.position + off, {}};
  if (rule.charges_turns) {
    const double curvature = join_curvature(std::sqrt(distance2), off_axis, rule.length_m) +
                             1.0 / step.now.turn_radius_m;
    found.turn = {1.0 / (curvature + rule.curvature_buffer_per_m) - rule.min_turn_radius_m +
                      step.now.since_start_m,
                  1.0 / curvature,
                  {found.at, now.yaw_rad}};
  }
  return found;
}

Crossing nearest_crossing(const CorridorGraph& graph,
                          std::uint32_t except,
                          const PathStep& step,
                          const CrossingRule& rule) noexcept {
  const Point a = step.before.pose.position;
  const Point b = step.now.pose.position;
  const Point margin{rule.merge_radius_m, rule.merge_radius_m};
  const Point low = Point{std::min(a.x_m, b.x_m), std::min(a.y_m, b.y_m)} - margin;
  const Point high = Point{std::max(a.x_m, b.x_m), std::max(a.y_m, b.y_m)} + margin;
  Crossing nearest;
  graph.for_each_node_near(low, high, [&](std::uint32_t node) noexcept {
    const Crossing found = node == except ? Crossing{} : crossing_of(graph, node, step, rule);
    const bool nearer = found.node != kNone &&
                        (nearest.node == kNone || found.distance2 < nearest.distance2 ||
                         (found.distance2 == nearest.distance2 && found.node < nearest.node));
    if (nearer) {
      nearest = found;
    }
  });
  return nearest;
}

}  // namespace tcert
