#pragma once
/// \file
/// A small world of discs and squares, felt by rays, for the tests of the witness.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <tcert/robot.hpp>
#include <vector>
#include <witness/samples.hpp>

namespace tcert::witness {

inline double drawn(std::mt19937& engine, double low, double high) {
  return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
}

/// Discs, and squares turned by any angle: at least 0.12 m wide, no corner below 90 degrees.
struct Walls {
  struct Wall {
    Point centre;
    double half_m;
    double yaw_rad;
    bool round;
  };
  std::vector<Wall> walls;

  /// Signed distance to the nearest wall; below 0 inside.
  [[nodiscard]] double distance_from(Point p) const {
    double least = 1e9;
    for (const Wall& wall : walls) {
      const Point off = p - wall.centre;
      double d = norm(off) - wall.half_m;
      if (!wall.round) {
        const Point u = direction(wall.yaw_rad);
        const double x = std::abs(dot(off, u)) - wall.half_m;
        const double y = std::abs(cross(u, off)) - wall.half_m;
        d = std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(std::max(x, y), 0.0);
      }
      least = std::min(least, d);
    }
    return least;
  }
  /// Way along `u` to the first wall, a little less than it is; by sphere tracing.
  [[nodiscard]] double cast(Point from, Point u, double reach_m) const {
    double way_m = 0.0;
    while (way_m < reach_m) {
      const double d = distance_from(from + way_m * u);
      if (d < 1e-7) {
        break;
      }
      way_m += d;
    }
    return std::clamp(way_m - 1e-6, 0.0, reach_m);
  }
};

inline Walls random_walls(std::mt19937& engine) {
  Walls world;
  for (int i = 0; i < 14; ++i) {
    const Point centre{drawn(engine, -1.5, 1.5), drawn(engine, -1.5, 1.5)};
    const double half_m = drawn(engine, 0.06, 0.2);
    if (norm(centre) > half_m * 1.5 + 0.3) {
      world.walls.push_back({centre, half_m, drawn(engine, 0.0, 3.0), engine() % 2 == 0});
    }
  }
  return world;
}

inline Ray range_ray(const char* name, Point mount, double bearing_rad, double reach_m) {
  return {name, mount, bearing_rad, reach_m, RayKind::range, {}};
}

/// Body 0.3 m wide, rays to both sides, ahead, and one mounted on the axis.
inline Robot small_robot() {
  Robot robot;
  robot.body_width_m = 0.3;
  robot.min_turn_radius_m = 0.2;
  robot.rays = {range_ray("left", {0.1, 0.05}, 0.5 * std::numbers::pi, 0.5),
                range_ray("right", {0.1, -0.05}, -0.5 * std::numbers::pi, 0.5),
                range_ray("front", {0.14, 0.0}, 0.0, 0.5),
                range_ray("axis", {0.0, 0.0}, 0.7, 0.5)};
  return robot;
}

/// A random drive that stays clear of the walls: arcs, turns on the spot, back and forth.
inline Samples random_drive(const Walls& walls,
                            const Robot& robot,
                            std::mt19937& engine,
                            int steps) {
  Samples samples;
  samples.rays = robot.rays.size();
  Pose pose{{0.0, 0.0}, drawn(engine, -3.0, 3.0)};
  double speed_m = 0.0;
  double turn_rad = 0.0;
  for (int i = 0; i < steps; ++i) {
    if (i % 25 == 0) {
      speed_m = engine() % 4 == 0 ? 0.0 : drawn(engine, -0.01, 0.02);
      turn_rad = drawn(engine, -0.06, 0.06);
    }
    const Pose next{pose.position + speed_m * direction(pose.yaw_rad), pose.yaw_rad + turn_rad};
    if (walls.distance_from(next.position) > 0.5 * robot.body_width_m + 0.001) {
      pose = next;
    } else {
      speed_m = -speed_m;
    }
    samples.poses.push_back(pose);
    samples.breaks.push_back(i == 0 ? 1 : 0);
    for (const Ray& ray : robot.rays) {
      samples.clearances_m.push_back(walls.cast(
          transform(pose, ray.mount), direction(pose.yaw_rad + ray.bearing_rad), ray.reach_m));
    }
  }
  return samples;
}

}  // namespace tcert::witness
