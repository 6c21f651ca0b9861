#include "datasets/corpus/figure_eight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

namespace tcert {
namespace {

constexpr double kHalfPostDistance = 2.4;
constexpr double kRegionCentre = 3.2;  // inside the lane behind its post for every radius
constexpr double kRegionRadius = 0.3;
constexpr double kLeastIslandRadius = 0.05;
constexpr double kArcStep = std::numbers::pi / 36.0;  // chords stay within 2 mm of the arc
constexpr double kJawOverlap = 0.03;                  // the jaws reach into the wall behind them
constexpr Point kExtent{4.5, 2.2};

double half_crossing_angle(const FigureEight& course) {
  return elementary::asin(course.radius_m / kHalfPostDistance);
}

/// From the lane over the first post to the others, by reflection.
Point reflected(Point p, Lane lane) {
  return {lane.at_goal ? -p.x_m : p.x_m, lane.upper ? p.y_m : -p.y_m};
}

Pose reflected(Pose pose, Lane lane) {
  const Point u = reflected(direction(pose.yaw_rad), lane);
  return {reflected(pose.position, lane), elementary::atan2(u.y_m, u.x_m)};
}

Point rounded(Point p) { return {std::round(p.x_m * 1e4) / 1e4, std::round(p.y_m * 1e4) / 1e4}; }

Polygon rounded(Polygon polygon) {
  for (Point& p : polygon.vertices) {
    p = rounded(p);
  }
  return polygon;
}

/// Points of a circle round the first post, from one angle to the other, both included.
void append_arc(std::vector<Point>& points, double radius, double from, double to) {
  const auto steps = static_cast<int>(std::ceil(std::abs(to - from) / kArcStep));
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / std::max(steps, 1);
    points.push_back(Point{-kHalfPostDistance, 0.0} + radius * direction(angle));
  }
}

/// What the lanes leave of the inside of the first lobe: a disc round the post, drawn out to the
/// point where the two lanes' inner walls would meet.
Polygon island(const FigureEight& course) {
  const double radius = std::max(course.radius_m - 0.5 * course.lane_width_m, kLeastIslandRadius);
  const double apex =
      kHalfPostDistance - 0.5 * course.lane_width_m / elementary::sin(half_crossing_angle(course));
  Polygon polygon;
  if (apex <= radius) {
    append_arc(polygon.vertices, radius, 0.0, 2.0 * std::numbers::pi);
    polygon.vertices.pop_back();
    return polygon;
  }
  const double tangent = elementary::acos(radius / apex);
  append_arc(polygon.vertices, radius, tangent, 2.0 * std::numbers::pi - tangent);
  polygon.vertices.push_back({-kHalfPostDistance + apex, 0.0});
  return polygon;
}

/// Everything above the outer wall of the upper lanes.
Polygon upper_wall(const FigureEight& course) {
  const double angle = half_crossing_angle(course);
  std::vector<Point> first;
  append_arc(first,
             course.radius_m + 0.5 * course.lane_width_m,
             std::numbers::pi,
             0.5 * std::numbers::pi - angle);
  Polygon polygon;
  polygon.vertices.push_back({-kExtent.x_m, 0.0});
  polygon.vertices.insert(polygon.vertices.end(), first.begin(), first.end());
  polygon.vertices.push_back({0.0, 0.5 * course.lane_width_m / elementary::cos(angle)});
  std::reverse(first.begin(), first.end());
  for (const Point p : first) {
    polygon.vertices.push_back({-p.x_m, p.y_m});
  }
  polygon.vertices.push_back({kExtent.x_m, 0.0});
  polygon.vertices.push_back(kExtent);
  polygon.vertices.push_back({-kExtent.x_m, kExtent.y_m});
  return polygon;
}

Polygon mirrored(Polygon polygon, double x_sign, double y_sign) {
  for (Point& p : polygon.vertices) {
    p = {x_sign * p.x_m, y_sign * p.y_m};
  }
  return polygon;
}

/// A jaw spans the lateral interval [from, to] of the pose's frame, `length` along its heading.
Polygon jaw(const Pose& middle, double length, double from, double to) {
  const double half = 0.5 * length;
  return {{transform(middle, {-half, from}),
           transform(middle, {half, from}),
           transform(middle, {half, to}),
           transform(middle, {-half, to})}};
}

}  // namespace

Region course_start() { return Disc{{-kRegionCentre, 0.0}, kRegionRadius}; }
Region course_goal() { return Disc{{kRegionCentre, 0.0}, kRegionRadius}; }

double lane_length(const FigureEight& course) {
  const double angle = half_crossing_angle(course);
  return course.radius_m * (0.5 * std::numbers::pi + angle) +
         kHalfPostDistance * elementary::cos(angle);
}

double walled_length(const FigureEight& course) {
  return lane_length(course) -
         0.5 * course.lane_width_m / elementary::tan(half_crossing_angle(course));
}

Pose lane_pose(const FigureEight& course, Lane lane, double along_m) {
  const double angle = half_crossing_angle(course);
  const double arc = course.radius_m * (0.5 * std::numbers::pi + angle);
  const double turned = std::min(along_m, arc) / course.radius_m;
  const double bearing = std::numbers::pi - turned;  // of the point, seen from the post
  const Point on_arc = Point{-kHalfPostDistance, 0.0} + course.radius_m * direction(bearing);
  const double yaw = bearing - 0.5 * std::numbers::pi;
  const Point p = on_arc + std::max(along_m - arc, 0.0) * direction(yaw);
  return reflected(Pose{p, yaw}, lane);
}

World build_world(const FigureEight& course, const std::vector<Gate>& gates) {
  World world;
  world.synthetic = true;
  world.bounds = {-1.0 * kExtent, kExtent};
  world.start = course_start();
  world.goal = course_goal();
  const Polygon inner = island(course);
  const Polygon outer = upper_wall(course);
  world.obstacles = {rounded(inner),
                     rounded(mirrored(inner, -1.0, 1.0)),
                     rounded(outer),
                     rounded(mirrored(outer, 1.0, -1.0))};
  for (const Gate& gate : gates) {
    const Pose middle = lane_pose(course, gate.lane, gate.along_m);
    const double wall = 0.5 * course.lane_width_m + kJawOverlap;
    const double left = gate.offset_m + 0.5 * gate.width_m;
    const double right = gate.offset_m - 0.5 * gate.width_m;
    world.obstacles.emplace_back(rounded(jaw(middle, gate.length_m, left, wall)));
    world.obstacles.emplace_back(rounded(jaw(middle, gate.length_m, right, -wall)));
  }
  return world;
}

}  // namespace tcert
