#pragma once
/// \file
/// A straight lane whose left and right sides are known apart, so that its passage is. Internal to
/// the families of random worlds.

#include <table/random.hpp>
#include <tcert/region.hpp>
#include <vector>

#include "datasets/random_worlds/random_world.hpp"

namespace tcert {

inline constexpr double kLaneEnd =
    0.6;  ///< Of S's middle from the lane's end, and of G's, if roomy.

/// A straight lane along x about y = 0, from x = 0; what is connected to its left wall, to its
/// right one, and to neither.
struct SidedLane {
  double length_m = 0.0;
  double width_m = 0.0;
  std::vector<Polygon> left;
  std::vector<Polygon> right;
  std::vector<Polygon> posts;
  Disc start;
  Disc goal;
  std::vector<Pose> way;  // through the middle of what is narrow, in order
};

[[nodiscard]] Polygon box(Point low, Point high);

[[nodiscard]] Polygon wall_of(const SidedLane& lane, double from_m, double to_m, bool left);

/// The jaw of one side between two distances along the lane, from `edge_m` into its wall.
[[nodiscard]] Polygon jaw(
    const SidedLane& lane, double from_m, double to_m, double edge_m, bool left);

/// Jaws that face each other squarely about `middle`, which may stand askew to the lane.
void add_gate(SidedLane& lane, const Pose& middle, double width_m, double length_m);

/// Two walls, and S and G with room about them.
[[nodiscard]] SidedLane walled_lane(double length_m, double width_m);

/// A cubic through poses: each is passed along its heading.
[[nodiscard]] std::vector<Point> path_through(const std::vector<Pose>& poses);

[[nodiscard]] std::vector<Point> moved(std::vector<Point> path, const Pose& frame);
[[nodiscard]] Pose draw_frame(table::RandomStream& random);

/// Where a run ends: beyond G's middle, as far as the cap lets the body go.
[[nodiscard]] Pose end_of(const SidedLane& lane);

/// The lane with its caps in `frame`; the legs are the caller's. Whoever gets from one end to the
/// other passes between what is connected to the left wall and what is connected to the right one:
/// no wider disc than the smallest distance of the two does.
[[nodiscard]] RandomWorld world_of(const SidedLane& lane, const Pose& frame);

/// The same with a run through the middle of what is narrow.
[[nodiscard]] RandomWorld world_to_cross(const SidedLane& lane, table::RandomStream& random);

}  // namespace tcert
