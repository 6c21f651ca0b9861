#pragma once
/// \file
/// Convex counter-clockwise polygons and what divides them.

#include <cstddef>
#include <optional>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// Line a-b as normal . z <= offset for what lies to its left.
struct HalfPlane {
  Eigen::Vector2d normal{0.0, 0.0};
  double offset = 0.0;
};

[[nodiscard]] HalfPlane left_of(const Position& a, const Position& b);

/// A half plane that holds convex `kept` and not the inside of convex `other`; none if they
/// overlap.
[[nodiscard]] std::optional<HalfPlane> separating(const std::vector<Position>& kept,
                                                  const std::vector<Position>& other);

[[nodiscard]] bool is_convex(const std::vector<Position>& polygon);

/// Where the ray from `from` along `direction` leaves the triangle it is in.
[[nodiscard]] Position exit_of(const Position& from,
                               const Eigen::Vector2d& direction,
                               const std::vector<Position>& triangle);

/// A convex collar round a convex counter-clockwise core: edges moved out by `width`, corners cut
/// at that distance; edges listed in `fixed` stay.
[[nodiscard]] std::vector<Position> collar_round(const std::vector<Position>& core,
                                                 double width,
                                                 const std::vector<std::size_t>& fixed);

}  // namespace tcert::terrain
