#pragma once
/// \file
/// The robot's local free space: its cell of the power diagram with the obstacles, eroded.

#include <optional>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

struct Disc {
  Position centre{0.0, 0.0};
  double radius = 0.0;
};

/// The cell of `robot` among `obstacles`, {z : |z-y|^2 - r^2 <= |z-c|^2 - rho^2 for all}, within
/// `box` (convex, counter-clockwise). Counter-clockwise; empty if there is none. O(box obstacles).
[[nodiscard]] std::vector<Position> power_cell(const Disc& robot,
                                               const std::vector<Disc>& obstacles,
                                               std::vector<Position> box);

/// The points of a convex polygon at depth >= `depth`; empty if there are none.
[[nodiscard]] std::vector<Position> eroded(const std::vector<Position>& polygon, double depth);

/// The part of a convex polygon where normal . z <= offset.
[[nodiscard]] std::vector<Position> clipped(const std::vector<Position>& polygon,
                                            const Eigen::Vector2d& normal,
                                            double offset);

/// The point of a convex counter-clockwise polygon nearest to `p`, which is `p` if it lies inside.
/// \pre the polygon is not empty
[[nodiscard]] Position nearest_point(const std::vector<Position>& polygon, const Position& p);

}  // namespace tcert::terrain
