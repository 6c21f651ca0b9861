#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/barrier_law.hpp>

namespace tcert {
namespace {

constexpr int kShrinkings = 16;
constexpr double kShrunk = 0.875;
constexpr double kRounding = 1e-12;  // m

/// Where a body comes to that drives an arc.
Pose driven(const Pose& pose, const Command& command, double seconds) noexcept {
  const double turn_rad = command.yaw_rate_rps * seconds;
  const double way_m = command.speed_mps * seconds;
  // The chord of the arc points half way between both headings.
  const double half = 0.5 * turn_rad;
  const double chord_m = half == 0.0 ? way_m : way_m * (elementary::sin(half) / half);
  return {pose.position + chord_m * direction(pose.yaw_rad + half), pose.yaw_rad + turn_rad};
}

double slack_of(Point felt, const Pose& pose, double half_width_m, const SpeedLaw& law) noexcept {
  const Point ahead = pose.position + law.barrier_point_m * direction(pose.yaw_rad);
  return distance(felt, ahead) - (half_width_m + law.barrier_point_m);
}

}  // namespace

BarrierRows barrier_rows(const FeltPoints::Nearest& felt,
                         const Pose& pose,
                         double half_width_m,
                         const SpeedLaw& law) noexcept {
  BarrierRows barrier;
  barrier.count = felt.count;
  barrier.front_m = std::numeric_limits<double>::infinity();
  const Point heading = direction(pose.yaw_rad);
  const Point across{-heading.y_m, heading.x_m};
  const Point ahead = pose.position + law.barrier_point_m * heading;
  for (std::size_t k = 0; k < felt.count; ++k) {
    const Point away = felt.points[k] - ahead;
    const double distance_m = norm(away);
    const double slack_m = distance_m - (half_width_m + law.barrier_point_m);
    const Point n = distance_m > 0.0 ? (1.0 / distance_m) * away : heading;
    barrier.rows[k] = {
        -dot(n, heading), -law.barrier_point_m * dot(n, across), -law.barrier_gain_per_s * slack_m};
    barrier.slack_m[k] = slack_m;
    const Point seen = felt.points[k] - pose.position;
    if (dot(seen, heading) > 0.0 && std::abs(dot(seen, across)) < half_width_m) {
      barrier.front_m = std::min(barrier.front_m, slack_m);
    }
  }
  return barrier;
}

FilteredCommand barrier_command(const Command& wanted,
                                const FeltPoints& felt,
                                const Pose& pose,
                                double half_width_m,
                                double period_s,
                                const SpeedLaw& law) noexcept {
  if (!(wanted.speed_mps >= 0.0)) {
    return {wanted, true};
  }
  const FeltPoints::Nearest near =
      felt.nearest(pose.position + law.barrier_point_m * direction(pose.yaw_rad));
  const BarrierRows barrier = barrier_rows(near, pose, half_width_m, law);
  const double stops_mps = std::sqrt(2.0 * law.brake_mps2 * std::max(barrier.front_m, 0.0));
  const CommandBox box{0.0,
                       std::min(law.max_speed_mps, stops_mps),
                       law.max_yaw_rate_rps,
                       law.max_speed_mps,
                       law.max_yaw_rate_rps};
  FilteredCommand filtered =
      nearest_command(wanted, std::span(barrier.rows).first(barrier.count), box);
  const double kept = 1.0 - std::min(law.barrier_gain_per_s * period_s, 1.0);
  for (int shrinking = 0; filtered.feasible; ++shrinking) {
    const Pose then = driven(pose, filtered.command, period_s);
    bool keeps = true;
    for (std::size_t k = 0; k < barrier.count; ++k) {
      keeps = keeps && slack_of(near.points[k], then, half_width_m, law) >=
                           kept * barrier.slack_m[k] - kRounding;
    }
    if (keeps || shrinking > kShrinkings) {
      break;
    }
    const double part = shrinking < kShrinkings ? kShrunk : 0.0;
    filtered.command = {part * filtered.command.speed_mps, part * filtered.command.yaw_rate_rps};
  }
  return filtered;
}

}  // namespace tcert
