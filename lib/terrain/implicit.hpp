#pragma once
/// \file
/// Implicit functions of the plane with their gradients, and their conjunction.

#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

struct Implicit {
  double value = 0.0;
  Eigen::Vector2d gradient{0.0, 0.0};
};

/// The p of the conjunction, as published.
inline constexpr int kConjunctionPower = 10;

/// a and b: a + b - (a^p + b^p)^(1/p), which is positive where both are and zero on the border.
[[nodiscard]] Implicit conjunction(const Implicit& a, const Implicit& b);

/// Signed distance to the line through `on` with unit normal `normal`, positive on its side.
[[nodiscard]] Implicit half_plane(const Position& x,
                                  const Position& on,
                                  const Eigen::Vector2d& normal);

/// Unit normals of a polygon's edges k -> k+1, pointing inwards if it is counter-clockwise.
[[nodiscard]] std::vector<Eigen::Vector2d> inward_normals(const std::vector<Position>& polygon);

}  // namespace tcert::terrain
