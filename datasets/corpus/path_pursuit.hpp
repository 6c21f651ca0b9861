#pragma once
/// \file
/// Following a path by aiming at a point ahead on it. Internal to drive.cpp.

#include <cstddef>
#include <tcert/region.hpp>
#include <vector>

namespace tcert {

/// Curvature that leads from `pose` to a point, on a circle that starts along the heading.
[[nodiscard]] double pursuit_curvature(const Pose& pose, Point target) noexcept;

/// How far a leg has been followed.
class PathProgress {
 public:
  void restart() noexcept { nearest_ = 0; }

  /// The point a lookahead beyond the nearest, searched forward only: paths cross themselves.
  Point target(const std::vector<Point>& path, Point p) noexcept;

  [[nodiscard]] bool finished(const std::vector<Point>& path) const noexcept {
    return nearest_ + 2 >= path.size();
  }

 private:
  std::size_t nearest_ = 0;
};

}  // namespace tcert
