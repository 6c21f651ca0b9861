#pragma once
/// \file
/// The diffeomorphism of a part of the ground: its uncertified surroundings and pockets become
/// discs and points that a controller can be kept away from.

#include <optional>
#include <terrain/outline.hpp>
#include <terrain/power_cell.hpp>
#include <terrain/triangle_map.hpp>
#include <vector>

namespace tcert::terrain {

/// What is not ground within the box round one part of it.
struct PseudoObstacle {
  std::vector<Position> polygon;  ///< Simple, counter-clockwise.
  bool on_border = false;         ///< It has an edge on the box.
};

struct Box {
  Position low{0.0, 0.0};
  Position high{0.0, 0.0};
};

[[nodiscard]] Box box_round(const std::vector<Cell>& ring);

/// The box round the outline without the outline, in pieces, then its holes.
[[nodiscard]] std::vector<PseudoObstacle> pseudo_obstacles(const Outline& outline);

/// A convex collar round a convex counter-clockwise core: edges moved out by `width`, corners cut
/// at that distance; edges listed in `fixed` stay.
[[nodiscard]] std::vector<Position> collar_round(const std::vector<Position>& core,
                                                 double width,
                                                 const std::vector<std::size_t>& fixed);

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
