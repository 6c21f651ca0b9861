#pragma once
/// \file
/// What is not ground within the box round one part of it, in pieces.

#include <terrain/grid.hpp>
#include <terrain/outline.hpp>
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

/// \pre there is a point
[[nodiscard]] Box box_round(const std::vector<Position>& points);
[[nodiscard]] Box box_round(const std::vector<Cell>& ring);

/// The box round the outline without the outline, in pieces, then its holes.
[[nodiscard]] std::vector<PseudoObstacle> pseudo_obstacles(const Outline& outline);

}  // namespace tcert::terrain
