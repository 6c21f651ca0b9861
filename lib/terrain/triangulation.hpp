#pragma once
/// \file
/// Simple polygons as trees of triangles.

#include <array>
#include <cstddef>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// Corners as indices into the polygon, counter-clockwise.
using Triangle = std::array<std::size_t, 3>;

/// Ear clipping of a simple counter-clockwise polygon: n - 2 triangles; empty if the polygon is not
/// simple (no ear is found) or has fewer than three corners. O(n^2) as a rule, O(n^3) at worst.
[[nodiscard]] std::vector<Triangle> ear_clipping(const std::vector<Position>& polygon);

/// A triangle of the tree: its parent comes later, the root last.
struct TreeTriangle {
  Triangle corners{};      ///< v0-v1 is the edge shared with the parent; counter-clockwise.
  std::size_t parent = 0;  ///< Index of the parent; of the root its own.
  std::size_t depth = 0;
};

/// The dual tree, by breadth-first search over shared edges from `root`, deepest first.
[[nodiscard]] std::vector<TreeTriangle> triangle_tree(const std::vector<Triangle>& triangles,
                                                      std::size_t root);

/// Twice the signed area of a, b, c.
[[nodiscard]] double doubled_area(const Position& a, const Position& b, const Position& c) noexcept;

}  // namespace tcert::terrain
