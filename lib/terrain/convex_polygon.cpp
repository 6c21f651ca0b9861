#include <algorithm>
#include <limits>
#include <terrain/convex_polygon.hpp>
#include <terrain/power_cell.hpp>
#include <terrain/pseudo_obstacles.hpp>
#include <terrain/triangulation.hpp>

namespace tcert::terrain {

HalfPlane left_of(const Position& a, const Position& b) {
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d right(along.y(), -along.x());
  return {right, right.dot(a)};
}

std::optional<HalfPlane> separating(const std::vector<Position>& kept,
                                    const std::vector<Position>& other) {
  constexpr double kTouch = 1e-9;
  std::optional<HalfPlane> best;
  double widest = -kTouch;
  const auto try_edges = [&](const std::vector<Position>& of, bool keep_left) {
    for (std::size_t k = 0; k < of.size(); ++k) {
      HalfPlane plane = left_of(of[k], of[(k + 1) % of.size()]);
      if (!keep_left) {
        plane = {-plane.normal, -plane.offset};
      }
      double kept_over = -std::numeric_limits<double>::infinity();
      double other_under = std::numeric_limits<double>::infinity();
      for (const Position& p : kept) {
        kept_over = std::max(kept_over, plane.normal.dot(p) - plane.offset);
      }
      for (const Position& p : other) {
        other_under = std::min(other_under, plane.normal.dot(p) - plane.offset);
      }
      const double gap = other_under - std::max(kept_over, 0.0);
      if (kept_over <= kTouch && gap > widest) {
        widest = gap;
        best = plane;
      }
    }
  };
  try_edges(other, false);
  try_edges(kept, true);
  return best;
}

bool is_convex(const std::vector<Position>& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    if (!(doubled_area(polygon[k],
                       polygon[(k + 1) % polygon.size()],
                       polygon[(k + 2) % polygon.size()]) > 1e-12)) {
      return false;
    }
  }
  return true;
}

Position exit_of(const Position& from,
                 const Eigen::Vector2d& direction,
                 const std::vector<Position>& triangle) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const HalfPlane plane = left_of(triangle[k], triangle[(k + 1) % 3]);
    const double rate = plane.normal.dot(direction);
    const double gap = plane.offset - plane.normal.dot(from);
    if (rate > 1e-12 && gap > 1e-9) {
      const double at = gap / rate;
      farthest = farthest == 0.0 ? at : std::min(farthest, at);
    }
  }
  return from + farthest * direction;
}

std::vector<Position> collar_round(const std::vector<Position>& core,
                                   double width,
                                   const std::vector<std::size_t>& fixed) {
  const auto [low, high] = box_round(core);
  const double margin = 2.0 * width;
  std::vector<Position> collar{{low.x() - margin, low.y() - margin},
                               {high.x() + margin, low.y() - margin},
                               {high.x() + margin, high.y() + margin},
                               {low.x() - margin, high.y() + margin}};
  const std::size_t n = core.size();
  std::vector<HalfPlane> edges;
  for (std::size_t k = 0; k < n; ++k) {
    edges.push_back(left_of(core[k], core[(k + 1) % n]));
  }
  for (std::size_t k = 0; k < n; ++k) {
    const bool stays = std::find(fixed.begin(), fixed.end(), k) != fixed.end();
    collar = clipped(collar, edges[k].normal, edges[k].offset + (stays ? 0.0 : width));
    const Eigen::Vector2d corner = edges[(k + n - 1) % n].normal + edges[k].normal;
    if (corner.norm() > 1e-9) {
      const Eigen::Vector2d normal = corner.normalized();
      collar = clipped(collar, normal, normal.dot(core[k]) + width);
    }
  }
  return collar;
}

}  // namespace tcert::terrain
