#include <algorithm>
#include <cmath>
#include <federation/join.hpp>
#include <tcert/crossing.hpp>
#include <tcert/elementary.hpp>

namespace tcert::federation {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

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

double join_margin(const JoinEnd& from,
                   const JoinEnd& to,
                   const FrameError& error,
                   const Agent& agent) noexcept {
  const double least_m = std::min(from.margin_m, to.margin_m);
  const double mean_m = 0.5 * (from.margin_m + to.margin_m);
  const Point way = to.pose.position - from.pose.position;
  const double turn_rad = angle_between(from.pose.yaw_rad, to.pose.yaw_rad);
  const bool is_sure = error.position_m == 0.0 && error.heading_rad == 0.0;
  if (is_sure && way == Point{} && turn_rad == 0.0) {
    return std::min(least_m, mean_m);
  }
  const Point heading = direction(from.pose.yaw_rad);
  const double ahead_m = dot(way, heading);
  // A heading that is off moves what lies at the end of the way, too.
  const double off_m = error.position_m + norm(way) * error.heading_rad;
  const double sharpest_rad = std::abs(turn_rad) + error.heading_rad;
  const double shortest_m = ahead_m - off_m;
  if (!(shortest_m > 0.0) || !(sharpest_rad < kSharpestJoin)) {
    return kNever;
  }
  const double offset_m =
      largest_offset(ahead_m, cross(heading, way), turn_rad, off_m, error.heading_rad);
  const double curvature = join_curvature(offset_m, sharpest_rad, 0.5 * shortest_m);
  // Of two parabolas the slope is largest at an end or where they meet, and nowhere above this.
  const double longest_m = ahead_m + off_m;
  const double steepest = elementary::tan(sharpest_rad) + 0.5 * curvature * longest_m;
  const double length_m = longest_m * std::sqrt(1.0 + steepest * steepest);
  const double turn_slack_m =
      1.0 / (curvature + agent.curvature_buffer_per_m) - agent.min_turn_radius_m;
  return std::min({least_m, mean_m - length_m, turn_slack_m});
}

}  // namespace tcert::federation
