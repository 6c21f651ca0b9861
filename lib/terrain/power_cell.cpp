#include <algorithm>
#include <limits>
#include <terrain/implicit.hpp>
#include <terrain/power_cell.hpp>

namespace tcert::terrain {

std::vector<Position> clipped(const std::vector<Position>& polygon,
                              const Eigen::Vector2d& normal,
                              double offset) {
  std::vector<Position> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Position& a = polygon[k];
    const Position& b = polygon[(k + 1) % polygon.size()];
    const double fa = normal.dot(a) - offset;
    const double fb = normal.dot(b) - offset;
    if (fa <= 0.0) {
      kept.push_back(a);
    }
    if ((fa < 0.0 && fb > 0.0) || (fa > 0.0 && fb < 0.0)) {
      kept.emplace_back(a + (b - a) * (fa / (fa - fb)));
    }
  }
  return kept;
}

std::vector<Position> power_cell(const Disc& robot,
                                 const std::vector<Disc>& obstacles,
                                 std::vector<Position> box) {
  for (const Disc& obstacle : obstacles) {
    const Eigen::Vector2d normal = 2.0 * (obstacle.centre - robot.centre);
    const double offset = obstacle.centre.squaredNorm() - obstacle.radius * obstacle.radius -
                          robot.centre.squaredNorm() + robot.radius * robot.radius;
    box = clipped(box, normal, offset);
  }
  return box;
}

std::vector<Position> eroded(const std::vector<Position>& polygon, double depth) {
  std::vector<Position> inner = polygon;
  if (polygon.size() < 3) {
    return {};
  }
  const std::vector<Eigen::Vector2d> normals = inward_normals(polygon);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    if (polygon[k] != polygon[(k + 1) % polygon.size()]) {
      inner = clipped(inner, -normals[k], -(normals[k].dot(polygon[k]) + depth));
    }
  }
  return inner;
}

Position nearest_point(const std::vector<Position>& polygon, const Position& p) {
  bool inside = polygon.size() > 2;
  double best = std::numeric_limits<double>::infinity();
  Position nearest = polygon.front();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Position& a = polygon[k];
    const Eigen::Vector2d along = polygon[(k + 1) % polygon.size()] - a;
    const Eigen::Vector2d to = p - a;
    inside = inside && along.x() * to.y() - along.y() * to.x() >= 0.0;
    const double length2 = along.squaredNorm();
    const double at = length2 > 0.0 ? std::clamp(to.dot(along) / length2, 0.0, 1.0) : 0.0;
    const double d2 = (to - at * along).squaredNorm();
    if (d2 < best) {
      best = d2;
      nearest = a + at * along;
    }
  }
  return inside ? p : nearest;
}

}  // namespace tcert::terrain
