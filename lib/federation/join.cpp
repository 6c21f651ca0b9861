#include <algorithm>
#include <cmath>
#include <federation/join.hpp>
#include <tcert/crossing.hpp>
#include <tcert/elementary.hpp>
#include <tcert/segment.hpp>

namespace tcert::federation {
namespace {

/// The largest offset at the middle line, |aside - ahead tan(turn) / 2|, over all that may be.
double largest_offset(
    double ahead_m, double aside_m, double turn_rad, double off_m, double off_rad) noexcept {
  double most_m = 0.0;
  for (const double turn : {turn_rad - off_rad, turn_rad + off_rad}) {
    const double slope = elementary::tan(turn);
    for (const double ahead : {ahead_m - off_m, ahead_m + off_m}) {
      most_m = std::max(most_m, std::abs(aside_m - 0.5 * ahead * slope));
    }
  }
  return most_m + off_m;
}

}  // namespace

std::optional<JoinShape> join_shape(const Pose& from,
                                    const Pose& to,
                                    const FrameError& error,
                                    const Agent& agent) noexcept {
  const Point way = to.position - from.position;
  const double turn_rad = angle_between(from.yaw_rad, to.yaw_rad);
  const bool is_sure = error.position_m == 0.0 && error.heading_rad == 0.0;
  if (is_sure && way == Point{} && turn_rad == 0.0) {
    return JoinShape{0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0};
  }
  const Point heading = direction(from.yaw_rad);
  const double ahead_m = dot(way, heading);
  // A heading that is off moves what lies at the end of the way, too.
  const double off_m = error.position_m + norm(way) * error.heading_rad;
  const double sharpest_rad = std::abs(turn_rad) + error.heading_rad;
  const double shortest_m = ahead_m - off_m;
  if (!(shortest_m > 0.0) || !(sharpest_rad < kSharpestJoin)) {
    return std::nullopt;
  }
  const double offset_m =
      largest_offset(ahead_m, cross(heading, way), turn_rad, off_m, error.heading_rad);
  const double curvature = join_curvature(offset_m, sharpest_rad, 0.5 * shortest_m);
  // Of two parabolas the slope is largest at an end or where they meet, and nowhere above this.
  const double longest_m = ahead_m + off_m;
  const double steepest = elementary::tan(sharpest_rad) + 0.5 * curvature * longest_m;
  return JoinShape{longest_m * std::sqrt(1.0 + steepest * steepest),
                   1.0 / (curvature + agent.curvature_buffer_per_m) - agent.min_turn_radius_m,
                   0.125 * curvature * longest_m * longest_m,
                   off_m};
}

double join_margin(const JoinEnd& from, const JoinEnd& to, const JoinShape& shape) noexcept {
  return std::min({from.margin_m,
                   to.margin_m,
                   0.5 * (from.margin_m + to.margin_m) - shape.length_m,
                   shape.turn_slack_m});
}

double margin_beside(const Pose& from,
                     const Pose& to,
                     const JoinShape& shape,
                     const Stretch* ahead,
                     const Stretch* behind) noexcept {
  constexpr int kParts = 8;
  const auto beside = [&](const Stretch& edge, Point p, Point q) {
    const double away_m =
        std::max(distance_to_segment(p, edge.a, edge.b), distance_to_segment(q, edge.a, edge.b));
    return edge.margin_m - 2.0 * (away_m + shape.bow_m + shape.off_m + edge.spread_m);
  };
  double best_m = -std::numeric_limits<double>::infinity();
  for (int part = behind == nullptr ? kParts : 0; part <= (ahead == nullptr ? 0 : kParts); ++part) {
    const Point change =
        from.position + static_cast<double>(part) / kParts * (to.position - from.position);
    const double first_m = part == 0 ? shape.turn_slack_m : beside(*ahead, from.position, change);
    const double second_m =
        part == kParts ? shape.turn_slack_m : beside(*behind, change, to.position);
    best_m = std::max(best_m, std::min(first_m, second_m));
  }
  return std::min(best_m, shape.turn_slack_m);
}

}  // namespace tcert::federation
