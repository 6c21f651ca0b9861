#pragma once
/// \file
/// A lane between two walls, along a centre line of straights and arcs.

#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/world.hpp"

namespace tcert {

inline constexpr double kWallThickness = 0.25;

/// A piece of a centre line; curvature 0 is straight, above 0 turns left.
struct LanePiece {
  double length_m = 0.0;
  double curvature_per_m = 0.0;
};

/// A narrowing by two jaws that face each other squarely.
struct LaneGate {
  double along_m = 0.0;   ///< Of its middle, on the centre line.
  double offset_m = 0.0;  ///< Of its middle, to the left of the centre line.
  double width_m = 0.0;
  double length_m = 0.0;
};

struct WalledLane {
  Pose begin;
  std::vector<LanePiece> pieces;
  double width_m = 1.0;
  std::vector<LaneGate> gates;
};

[[nodiscard]] double length_of(const WalledLane& lane) noexcept;
[[nodiscard]] Pose pose_at(const WalledLane& lane, double along_m) noexcept;

/// The narrowest gate, or the lane's own width.
[[nodiscard]] double passage_of(const WalledLane& lane) noexcept;

/// Walls along both sides: the chords of the centre line, moved to either side by half of the
/// lane's width, so that the widest disc that gets through has exactly that width. \pre arcs are
/// wide enough for the wall on their inside.
void add_walls(World& world, const WalledLane& lane);
/// A wall across each end.
void add_caps(World& world, const WalledLane& lane);
void add_gates(World& world, const WalledLane& lane);

/// Along the centre line from `from_m` to `to_m`, through the middle of every gate.
[[nodiscard]] std::vector<Point> path_along(const WalledLane& lane, double from_m, double to_m);

/// A rectangle in the frame of a pose.
[[nodiscard]] Polygon box_at(const Pose& pose, Point low, Point high);

/// Bounds round everything that the obstacles of a world reach.
[[nodiscard]] Bounds bounds_of(const World& world, double margin_m);

}  // namespace tcert
