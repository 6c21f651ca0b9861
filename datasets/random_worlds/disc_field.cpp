#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/families.hpp"
#include "datasets/random_worlds/walled_lane.hpp"

namespace tcert {
namespace {

constexpr double kLeastGap = 0.003;  // between the body on its way and a disc
constexpr double kRoom = 0.9;        // behind S and behind G

/// From S to G, with a swing to one side and one to the other.
std::vector<Point> winding_path(double length, double swing, double waves) {
  std::vector<Point> path = straight_path({0.0, 0.0}, {length + 0.2, 0.0});
  for (Point& p : path) {
    const double share = std::clamp(p.x_m / length, 0.0, 1.0);
    const double envelope = elementary::sin(std::numbers::pi * share);
    p.y_m = swing * envelope * envelope * elementary::sin(2.0 * std::numbers::pi * waves * share);
  }
  return path;
}

double distance_to(const std::vector<Point>& path, Point p) {
  double least2 = dot(path[0] - p, path[0] - p);
  for (const Point q : path) {
    least2 = std::min(least2, dot(q - p, q - p));
  }
  return std::sqrt(least2);
}

}  // namespace

// The path comes first; discs that would stand in its way are drawn again.
RandomWorld draw_discs(table::RandomStream& random) {
  RandomWorld drawn;
  const double length = random.uniform(2.6, 3.6);
  const double half = random.uniform(0.7, 1.4);
  drawn.world.bounds = {{-kRoom, -half}, {length + kRoom, half}};
  drawn.world.start = Disc{{0.0, 0.0}, kRandomRegionRadius};
  drawn.world.goal = Disc{{length, 0.0}, kRandomRegionRadius};
  const std::vector<Point> path =
      winding_path(length, random.uniform(0.0, 0.6) * (half - 0.4), random.uniform(0.5, 1.2));
  drawn.legs = {{path, false}};

  const bool equal = random.below(2) == 0;
  const double radius = random.uniform(0.06, 0.25);
  const double body = 0.5 * corpus_robot().body_width_m;
  const std::uint32_t tries = 20 + random.below(80);
  for (std::uint32_t i = 0; i < tries; ++i) {
    const Disc disc{{random.uniform(-kRoom, length + kRoom), random.uniform(-half, half)},
                    equal ? radius : random.uniform(0.06, 0.30)};
    const double clear = kRandomRegionRadius + disc.radius_m + 0.001;
    if (distance_to(path, disc.centre) > body + disc.radius_m + kLeastGap &&
        distance(disc.centre, {0.0, 0.0}) > clear && distance(disc.centre, {length, 0.0}) > clear) {
      drawn.world.obstacles.emplace_back(disc);
    }
  }

  const auto& [low, high] = drawn.world.bounds;
  const double t = kWallThickness;
  const Pose origin;
  drawn.edge_walls = {box_at(origin, low - Point{t, t}, {high.x_m + t, low.y_m}),
                      box_at(origin, {low.x_m - t, high.y_m}, high + Point{t, t}),
                      box_at(origin, low - Point{t, t}, {low.x_m, high.y_m + t}),
                      box_at(origin, {high.x_m, low.y_m - t}, high + Point{t, t})};
  return drawn;
}

}  // namespace tcert
