#pragma once
/// \file
/// The diffeomorphism of a part of the ground: its uncertified surroundings and pockets become
/// discs and points that a controller can be kept away from.

#include <cstddef>
#include <terrain/power_cell.hpp>
#include <terrain/pseudo_obstacles.hpp>
#include <terrain/triangle_map.hpp>
#include <vector>

namespace tcert::terrain {

class ObstacleMap {
 public:
  /// Obstacles whose polygon cannot be triangulated are left out and counted.
  ObstacleMap(const std::vector<PseudoObstacle>& obstacles, const MapParameters& parameters);

  /// h(x) and its Jacobian; the identity far from every obstacle.
  [[nodiscard]] Mapped map(const Position& x) const;

  /// Roots of the obstacles in the mapped plane: discs, points beyond the border.
  [[nodiscard]] const std::vector<Disc>& roots() const noexcept { return roots_; }
  [[nodiscard]] std::size_t triangles() const noexcept { return maps_.size(); }
  [[nodiscard]] std::size_t left_out() const noexcept { return left_out_; }

 private:
  void add(const PseudoObstacle& obstacle);

  MapParameters parameters_;
  std::vector<TriangleMap> maps_;  // in the order in which they are applied
  std::vector<Disc> roots_;
  std::size_t left_out_ = 0;
};

}  // namespace tcert::terrain
