#include "datasets/driven/driven_world.hpp"

#include <algorithm>
#include <tcert/elementary.hpp>

#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr double kWayPointSpacing = 0.2;

Point mirror_image(Point p) noexcept { return {p.x_m, -p.y_m}; }

Region mirror_image(Region region) {
  if (auto* disc = std::get_if<Disc>(&region)) {
    disc->centre = mirror_image(disc->centre);
  } else {
    for (Point& p : std::get<Polygon>(region).vertices) {
      p = mirror_image(p);
    }
  }
  return region;
}

/// The legs that lead on, each from where the next one begins, until G.
std::vector<Point> way_to_goal(const RandomWorld& drawn) {
  std::vector<Point> way = drawn.legs.front().path;
  for (std::size_t i = 1; i < drawn.legs.size(); ++i) {
    const std::vector<Point>& on = drawn.legs[i].path;
    if (!drawn.legs[i].reverse) {
      way.erase(std::min_element(way.begin(),
                                 way.end(),
                                 [&](Point a, Point b) {
                                   return distance(a, on.front()) < distance(b, on.front());
                                 }),
                way.end());
      way.insert(way.end(), on.begin(), on.end());
    }
  }
  const auto in_goal =
      std::find_if(way.begin(), way.end(), [&](Point p) { return contains(*drawn.world.goal, p); });
  way.erase(in_goal, way.end());
  way.push_back(middle_of(*drawn.world.goal));
  return way;
}

std::vector<Point> way_points(const std::vector<Point>& way) {
  std::vector<Point> points{way.front()};
  for (const Point p : way) {
    if (distance(points.back(), p) >= kWayPointSpacing) {
      points.push_back(p);
    }
  }
  if (!(points.back() == way.back())) {
    points.push_back(way.back());
  }
  return points;
}

}  // namespace

Point middle_of(const Region& region) {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return disc->centre;
  }
  const auto& vertices = std::get<Polygon>(region).vertices;
  Point sum;
  for (const Point p : vertices) {
    sum = sum + p;
  }
  return (1.0 / static_cast<double>(vertices.size())) * sum;
}

DrivenWorld driven_world(const RandomWorld& drawn) {
  DrivenWorld driven;
  driven.world = drawn.world;
  driven.edge_walls = drawn.edge_walls;
  const Leg& first = drawn.legs.front();
  const Point ahead = first.path[1] - first.path[0];
  driven.start = {first.path[0], elementary::atan2(ahead.y_m, ahead.x_m)};
  driven.lobes = {{way_points(way_to_goal(drawn))}};
  if (drawn.passage_m) {
    driven.margin_m = *drawn.passage_m - corpus_robot().body_width_m;
  }
  return driven;
}

DrivenWorld mirrored(const DrivenWorld& driven) {
  DrivenWorld image = driven;
  World& world = image.world;
  world.bounds = {{world.bounds.low.x_m, -driven.world.bounds.high.y_m},
                  {world.bounds.high.x_m, -driven.world.bounds.low.y_m}};
  for (Region& wall : world.obstacles) {
    wall = mirror_image(std::move(wall));
  }
  for (Region& wall : image.edge_walls) {
    wall = mirror_image(std::move(wall));
  }
  for (auto* region : {&world.start, &world.goal}) {
    if (*region) {
      **region = mirror_image(std::move(**region));
    }
  }
  image.start = {mirror_image(driven.start.position), -driven.start.yaw_rad};
  for (ReliefPatch& patch : image.relief) {
    patch.area.centre = mirror_image(patch.area.centre);
    patch.up = mirror_image(patch.up);
  }
  for (auto& lanes : image.lobes) {
    for (auto& lane : lanes) {
      std::transform(
          lane.begin(), lane.end(), lane.begin(), [](Point p) { return mirror_image(p); });
    }
  }
  return image;
}

WallIndex walls_of(const DrivenWorld& driven, double range_m) {
  World walled = driven.world;
  walled.obstacles.insert(
      walled.obstacles.end(), driven.edge_walls.begin(), driven.edge_walls.end());
  return {walled, range_m};
}

}  // namespace tcert
