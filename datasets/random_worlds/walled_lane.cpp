#include "datasets/random_worlds/walled_lane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/elementary.hpp>

#include "datasets/corpus/route.hpp"

namespace tcert {
namespace {

constexpr double kWallStep = 0.08;
constexpr double kLaneSwerve = 0.6;  // way before and after a gate on which its offset is taken up
constexpr double kWallOverlap = 0.05;  // the jaws reach into the wall behind them

Pose advanced(const Pose& from, double length_m, double curvature_per_m) noexcept {
  const double turn = length_m * curvature_per_m;
  const double chord =
      std::abs(turn) > 1e-12 ? 2.0 * elementary::sin(0.5 * turn) / curvature_per_m : length_m;
  return {from.position + chord * direction(from.yaw_rad + 0.5 * turn), from.yaw_rad + turn};
}

double swerve(const WalledLane& lane, double along_m) noexcept {
  double offset = 0.0;
  double weight = 0.0;
  for (const LaneGate& gate : lane.gates) {
    const double x = (along_m - gate.along_m) / kLaneSwerve;
    if (std::abs(x) < 1.0) {
      const double w = 0.5 * (1.0 + elementary::cos(std::numbers::pi * x));
      offset += w * w * gate.offset_m;
      weight += w;
    }
  }
  return weight > 0.0 ? offset / std::max(weight, 1e-9) * std::min(weight, 1.0) : 0.0;
}

/// Points of the lane's centre line, with the direction from each in which a wall's corner lies: in
/// it, at `across` times its length, the lines beside two chords at the distance `across` meet.
struct Corner {
  Point centre;
  Point outwards;
};

std::vector<Corner> corners_of(const WalledLane& lane) {
  const double length = length_of(lane);
  const auto steps = static_cast<int>(std::ceil(length / kWallStep));
  std::vector<Pose> poses;
  for (int i = 0; i <= steps; ++i) {
    poses.push_back(pose_at(lane, length * i / steps));
  }
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto chord = [&](std::size_t from) {
      const Point way = poses[from + 1].position - poses[from].position;
      return (1.0 / norm(way)) * way;
    };
    const Point before = i > 0 ? chord(i - 1) : chord(0);
    const Point after = i + 1 < poses.size() ? chord(i) : before;
    const bool is_end = i == 0 || i + 1 == poses.size();
    const Point along = is_end ? direction(poses[i].yaw_rad) : before + after;
    const Point normal = (1.0 / norm(along)) * Point{-along.y_m, along.x_m};
    corners.push_back({poses[i].position, (1.0 / cross(before, normal)) * normal});
  }
  return corners;
}

void add_side(World& world, const WalledLane& lane, double side) {
  const double near = side * 0.5 * lane.width_m;
  const double far = near + side * kWallThickness;
  const std::vector<Corner> corners = corners_of(lane);
  Polygon wall;
  for (const Corner& corner : corners) {
    wall.vertices.push_back(corner.centre + near * corner.outwards);
  }
  for (std::size_t i = corners.size(); i-- > 0;) {
    wall.vertices.push_back(corners[i].centre + far * corners[i].outwards);
  }
  world.obstacles.emplace_back(std::move(wall));
}

}  // namespace

double length_of(const WalledLane& lane) noexcept {
  double length = 0.0;
  for (const LanePiece& piece : lane.pieces) {
    length += piece.length_m;
  }
  return length;
}

Pose pose_at(const WalledLane& lane, double along_m) noexcept {
  Pose pose = lane.begin;
  for (std::size_t i = 0; i < lane.pieces.size(); ++i) {
    const LanePiece& piece = lane.pieces[i];
    const bool last = i + 1 == lane.pieces.size();
    const double part = last ? along_m : std::min(along_m, piece.length_m);
    pose = advanced(pose, part, piece.curvature_per_m);
    along_m -= part;
    if (along_m <= 0.0) {
      break;
    }
  }
  return pose;
}

double passage_of(const WalledLane& lane) noexcept {
  double least = lane.width_m;
  for (const LaneGate& gate : lane.gates) {
    least = std::min(least, gate.width_m);
  }
  return least;
}

void add_walls(World& world, const WalledLane& lane) {
  add_side(world, lane, 1.0);
  add_side(world, lane, -1.0);
}

void add_caps(World& world, const WalledLane& lane) {
  const double across = 0.5 * lane.width_m + kWallThickness;
  world.obstacles.emplace_back(
      box_at(pose_at(lane, 0.0), {-kWallThickness, -across}, {0.0, across}));
  world.obstacles.emplace_back(
      box_at(pose_at(lane, length_of(lane)), {0.0, -across}, {kWallThickness, across}));
}

void add_gates(World& world, const WalledLane& lane) {
  for (const LaneGate& gate : lane.gates) {
    const Pose middle = pose_at(lane, gate.along_m);
    const double half = 0.5 * gate.length_m;
    const double wall = 0.5 * lane.width_m + kWallOverlap;
    const double left = gate.offset_m + 0.5 * gate.width_m;
    const double right = gate.offset_m - 0.5 * gate.width_m;
    world.obstacles.emplace_back(box_at(middle, {-half, left}, {half, wall}));
    world.obstacles.emplace_back(box_at(middle, {-half, -wall}, {half, right}));
  }
}

std::vector<Point> path_along(const WalledLane& lane, double from_m, double to_m) {
  const auto steps = std::max(1, static_cast<int>(std::ceil(std::abs(to_m - from_m) / kPathStep)));
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i) {
    const double along = from_m + (to_m - from_m) * i / steps;
    points.push_back(transform(pose_at(lane, along), {0.0, swerve(lane, along)}));
  }
  return points;
}

Polygon box_at(const Pose& pose, Point low, Point high) {
  return {{transform(pose, low),
           transform(pose, {high.x_m, low.y_m}),
           transform(pose, high),
           transform(pose, {low.x_m, high.y_m})}};
}

Bounds bounds_of(const World& world, double margin_m) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds bounds{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Region& obstacle : world.obstacles) {
    for (const Point p : std::get<Polygon>(obstacle).vertices) {
      bounds.low = {std::min(bounds.low.x_m, p.x_m), std::min(bounds.low.y_m, p.y_m)};
      bounds.high = {std::max(bounds.high.x_m, p.x_m), std::max(bounds.high.y_m, p.y_m)};
    }
  }
  return {bounds.low - Point{margin_m, margin_m}, bounds.high + Point{margin_m, margin_m}};
}

}  // namespace tcert
