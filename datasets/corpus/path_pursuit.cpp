#include "datasets/corpus/path_pursuit.hpp"

#include <algorithm>

namespace tcert {
namespace {

constexpr double kLookahead = 0.30;
constexpr double kMostCurvature = 1.0 / 0.42;
constexpr std::size_t kWindow = 30;  // points that the nearest may be ahead

}  // namespace

double pursuit_curvature(const Pose& pose, Point target) noexcept {
  const Point d = target - pose.position;
  const double squared = std::max(dot(d, d), 1e-4);
  const double lateral = cross(direction(pose.yaw_rad), d);
  return std::clamp(2.0 * lateral / squared, -kMostCurvature, kMostCurvature);
}

Point PathProgress::target(const std::vector<Point>& path, Point p) noexcept {
  const std::size_t end = std::min(nearest_ + kWindow, path.size());
  for (std::size_t i = nearest_; i < end; ++i) {
    if (distance(path[i], p) <= distance(path[nearest_], p)) {
      nearest_ = i;
    }
  }
  std::size_t ahead = nearest_;
  while (ahead + 1 < path.size() && distance(path[ahead], p) < kLookahead) {
    ++ahead;
  }
  if (distance(path[ahead], p) < kLookahead && path.size() > 1) {
    const Point u = path.back() - path[path.size() - 2];
    return path.back() + (kLookahead / norm(u)) * u;
  }
  return path[ahead];
}

}  // namespace tcert
