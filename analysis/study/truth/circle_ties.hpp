#pragma once
/// \file
/// Points of a circle that are equally far from two obstacles.

#include <tcert/region.hpp>
#include <variant>
#include <vector>

namespace tcert::study {

/// The half-plane behind a wall: {p : dot(normal, p) <= offset_m}; `normal` is a unit vector.
struct Wall {
  Point normal;
  double offset_m = 0.0;
};

using Obstacle = std::variant<Disc, Wall>;

/// Distance to the surface; negative inside.
[[nodiscard]] inline double surface_distance(const Disc& disc, Point p) noexcept {
  return distance(p, disc.centre) - disc.radius_m;
}
[[nodiscard]] inline double surface_distance(const Wall& wall, Point p) noexcept {
  return dot(wall.normal, p) - wall.offset_m;
}
[[nodiscard]] inline double surface_distance(const Obstacle& obstacle, Point p) {
  return std::visit([p](const auto& o) { return surface_distance(o, p); }, obstacle);
}

/// All points of the circle with surface_distance(a, p) = surface_distance(b, p), and perhaps a
/// few more: at most four. Squaring away the roots leaves a trigonometric polynomial of degree 2 in
/// the angle, that is one of degree 4 in exp(i angle), solved by the eigenvalues of its companion
/// matrix.
[[nodiscard]] std::vector<Point> circle_ties(const Disc& circle,
                                             const Obstacle& a,
                                             const Obstacle& b);

}  // namespace tcert::study
