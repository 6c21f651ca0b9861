#include "datasets/corpus/route.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

namespace tcert {
namespace {

constexpr double kSwerve = 0.7;  // way before and after a gate on which its offset is taken up
constexpr double kCrossingRadius = 1.0;  // of the turn from one tangent to the other
constexpr double kBackOff = 0.15;        // before that turn begins

/// Offset of the path from a lane's centre line: raised cosines round its gates.
double swerve(const TrialCourse& trial, Lane lane, double along) {
  double offset = 0.0;
  double weight = 0.0;
  for (const Gate& gate : trial.gates) {
    const double x = (along - gate.along_m) / kSwerve;
    if (gate.lane == lane && std::abs(x) < 1.0) {
      const double w = 0.5 * (1.0 + elementary::cos(std::numbers::pi * x));
      offset += w * w * gate.offset_m;
      weight += w;
    }
  }
  return weight > 0.0 ? offset / std::max(weight, 1e-9) * std::min(weight, 1.0) : 0.0;
}

/// Points of a lane's path from its outer end until `until` of its length.
std::vector<Point> lane_path(const TrialCourse& trial, Lane lane, double until) {
  const auto steps = static_cast<int>(std::ceil(until / kPathStep));
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i) {
    const double along = until * i / steps;
    const Pose pose = lane_pose(trial.course, lane, along);
    points.push_back(transform(pose, {0.0, swerve(trial, lane, along)}));
  }
  return points;
}

/// The turn from the end of `before` onto the beginning of `after`, both on straight tangents that
/// meet at the origin.
std::vector<Point> crossing_turn(Point before, Point after) {
  const double heading = elementary::atan2(-before.y_m, -before.x_m);
  const double turn = angle_between(heading, elementary::atan2(after.y_m, after.x_m));
  const double radius = norm(before) / elementary::tan(0.5 * std::abs(turn));
  const double side = turn < 0.0 ? -1.0 : 1.0;
  const Point centre = before + (side * radius) * direction(heading + 0.5 * std::numbers::pi);
  const auto steps = static_cast<int>(std::ceil(radius * std::abs(turn) / kPathStep));
  std::vector<Point> points;
  for (int i = 1; i < steps; ++i) {
    const double bearing = heading - side * 0.5 * std::numbers::pi + turn * i / steps;
    points.push_back(centre + radius * direction(bearing));
  }
  return points;
}

void append(std::vector<Point>& path, const std::vector<Point>& more) {
  path.insert(path.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Point> straight_path(Point from, Point to) {
  const auto steps = std::max(1, static_cast<int>(std::ceil(distance(from, to) / kPathStep)));
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i) {
    points.push_back(from + (static_cast<double>(i) / steps) * (to - from));
  }
  return points;
}

std::vector<Leg> plan_legs(const TrialCourse& trial, bool look_in, double look_in_m) {
  const LanePair& route = trial.route;
  const double length = lane_length(trial.course);
  const bool straight_on = route.first.upper != route.second.upper;
  const double angle = elementary::asin(trial.course.radius_m / 2.4);
  const double cut = straight_on ? 0.0 : kCrossingRadius * elementary::tan(angle);
  std::vector<Point> first = lane_path(trial, route.first, length - cut);
  std::vector<Point> second = lane_path(trial, route.second, length - cut);
  std::reverse(second.begin(), second.end());
  std::vector<Point> way = first;
  if (straight_on) {
    way.pop_back();
  } else {
    append(way, crossing_turn(first.back(), second.front()));
  }
  append(way, second);
  if (!look_in) {
    return {{way, false}};
  }

  const Lane other{true, !route.second.upper};
  const Point towards = lane_pose(trial.course, other, length - look_in_m).position;
  std::vector<Leg> legs;
  const double angle_cut = kCrossingRadius * elementary::tan(angle) + kBackOff;
  const auto back_to = static_cast<std::size_t>((length - angle_cut) / kPathStep);
  std::vector<Point> into = first;
  if (straight_on) {
    // The lane that is not taken lies across the turn: approach it on the arc.
    const double turn_cut = kCrossingRadius * elementary::tan(angle);
    into = lane_path(trial, route.first, length - turn_cut);
    const Point out = lane_pose(trial.course, other, length - turn_cut).position;
    append(into, crossing_turn(into.back(), out));
    append(into, straight_path(out, towards));
  } else {
    append(into, straight_path(first.back(), towards));
  }
  std::vector<Point> back(into.begin() + static_cast<std::ptrdiff_t>(back_to), into.end());
  std::reverse(back.begin(), back.end());
  legs.push_back({into, false});
  legs.push_back({back, true});
  std::vector<Point> onward(way.begin() + static_cast<std::ptrdiff_t>(back_to), way.end());
  legs.push_back({onward, false});
  return legs;
}

}  // namespace tcert
