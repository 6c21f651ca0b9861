#include "datasets/random_worlds/sided_lane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>
#include <utility>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/families.hpp"
#include "datasets/random_worlds/walled_lane.hpp"
#include "datasets/worlds/region_distance.hpp"

namespace tcert {
namespace {

constexpr double kIntoWall = 0.05;    // what a jaw reaches into the wall behind it
constexpr double kLeastRoom = 0.004;  // between the body and a wall, for a run that gets through

double half_body_m() { return 0.5 * corpus_robot().body_width_m; }

double passage_between(const SidedLane& lane) {
  double least = lane.width_m;
  for (const Polygon& left : lane.left) {
    for (const Polygon& right : lane.right) {
      least = std::min(least, region_gap(left, right));
    }
  }
  return least;
}

Region moved(const Region& region, const Pose& frame) {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return Disc{transform(frame, disc->centre), disc->radius_m};
  }
  Polygon polygon = std::get<Polygon>(region);
  for (Point& vertex : polygon.vertices) {
    vertex = transform(frame, vertex);
  }
  return polygon;
}

}  // namespace

Polygon box(Point low, Point high) { return box_at(Pose{}, low, high); }

Polygon wall_of(const SidedLane& lane, double from_m, double to_m, bool left) {
  const double near = 0.5 * lane.width_m;
  const double far = near + kWallThickness;
  return left ? box({from_m, near}, {to_m, far}) : box({from_m, -far}, {to_m, -near});
}

Polygon jaw(const SidedLane& lane, double from_m, double to_m, double edge_m, bool left) {
  const double wall = 0.5 * lane.width_m + kIntoWall;
  return left ? box({from_m, edge_m}, {to_m, wall}) : box({from_m, -wall}, {to_m, edge_m});
}

SidedLane walled_lane(double length_m, double width_m) {
  SidedLane lane;
  lane.length_m = length_m;
  lane.width_m = width_m;
  lane.left = {wall_of(lane, 0.0, length_m, true)};
  lane.right = {wall_of(lane, 0.0, length_m, false)};
  const double radius = std::min(kRandomRegionRadius, 0.5 * width_m - 0.005);
  lane.start = {{kLaneEnd, 0.0}, radius};
  lane.goal = {{length_m - kLaneEnd, 0.0}, radius};
  return lane;
}

std::vector<Point> path_through(const std::vector<Pose>& poses) {
  std::vector<Point> path;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Point a = poses[i].position;
    const Point b = poses[i + 1].position;
    const double way = distance(a, b);
    const Point from = way * direction(poses[i].yaw_rad);
    const Point to = way * direction(poses[i + 1].yaw_rad);
    const auto steps = std::max(2, static_cast<int>(std::ceil(way / kPathStep)));
    for (int k = i == 0 ? 0 : 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const double rest = 1.0 - t;
      path.push_back(rest * rest * (1.0 + 2.0 * t) * a + t * rest * rest * from +
                     t * t * (3.0 - 2.0 * t) * b + -(t * t * rest) * to);
    }
  }
  return path;
}

std::vector<Point> moved(std::vector<Point> path, const Pose& frame) {
  for (Point& p : path) {
    p = transform(frame, p);
  }
  return path;
}

Pose draw_frame(table::RandomStream& random) {
  return {{0.0, 0.0}, random.uniform(-std::numbers::pi, std::numbers::pi)};
}

Pose end_of(const SidedLane& lane) {
  const double ahead = lane.length_m - lane.goal.centre.x_m - half_body_m() - kLeastRoom;
  return {lane.goal.centre + Point{std::min(kIntoGoal, ahead), 0.0}, 0.0};
}

RandomWorld world_of(const SidedLane& lane, const Pose& frame) {
  RandomWorld drawn;
  const double side = 0.5 * lane.width_m + kWallThickness;
  std::vector<Polygon> caps{box({-kWallThickness, -side}, {0.0, side}),
                            box({lane.length_m, -side}, {lane.length_m + kWallThickness, side})};
  for (const auto* some : {&lane.left, &lane.right, &lane.posts, &std::as_const(caps)}) {
    for (const Polygon& one : *some) {
      drawn.world.obstacles.push_back(moved(one, frame));
    }
  }
  drawn.world.start = moved(lane.start, frame);
  drawn.world.goal = moved(lane.goal, frame);
  drawn.world.bounds = bounds_of(drawn.world, 0.1);
  drawn.passage_m = passage_between(lane);
  return drawn;
}

RandomWorld world_to_cross(const SidedLane& lane, table::RandomStream& random) {
  const Pose frame = draw_frame(random);
  RandomWorld drawn = world_of(lane, frame);
  std::vector<Pose> way{{lane.start.centre, 0.0}};
  way.insert(way.end(), lane.way.begin(), lane.way.end());
  way.push_back(end_of(lane));
  drawn.legs = {{moved(path_through(way), frame), false}};
  return drawn;
}

void add_gate(SidedLane& lane, const Pose& middle, double width_m, double length_m) {
  const double reach = 0.5 * lane.width_m + kIntoWall + std::abs(middle.position.y_m);
  const double far = reach / elementary::cos(middle.yaw_rad);
  const double half = 0.5 * length_m;
  lane.left.push_back(box_at(middle, {-half, 0.5 * width_m}, {half, far}));
  lane.right.push_back(box_at(middle, {-half, -far}, {half, -0.5 * width_m}));
  lane.way.push_back(middle);
}

}  // namespace tcert
