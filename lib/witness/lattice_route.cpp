#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <witness/lattice_route.hpp>
#include <witness/region_shape.hpp>

namespace tcert::witness {
namespace {

constexpr double kNear = 0.06;  // m
constexpr float kNone = -1.0F;

class Vertices {
 public:
  explicit Vertices(const RouteGrid& grid)
      : grid_(grid),
        columns_((grid.field.columns() + grid.stride - 1) / grid.stride),
        rows_((grid.field.rows() + grid.stride - 1) / grid.stride) {}

  [[nodiscard]] std::size_t size() const noexcept {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }
  [[nodiscard]] float clearance(int i) const noexcept {
    return static_cast<float>(
        grid_.field.at_vertex(i % columns_ * grid_.stride, i / columns_ * grid_.stride));
  }
  [[nodiscard]] Point position(int i) const noexcept {
    return grid_.field.position(i % columns_ * grid_.stride, i / columns_ * grid_.stride);
  }
  [[nodiscard]] bool in_goal(int i) const noexcept { return contains(grid_.goal, position(i)); }

  /// Vertices within S.
  [[nodiscard]] std::vector<int> starts() const {
    std::vector<int> found;
    const Box box = bounding_box(grid_.start);
    for (int i = 0; i < static_cast<int>(size()); ++i) {
      const Point p = position(i);
      if (p.y_m < box.low.y_m || p.y_m > box.high.y_m) {
        i += columns_ - i % columns_ - 1;
        continue;
      }
      if (contains(grid_.start, p)) {
        found.push_back(i);
      }
    }
    return found;
  }

  /// visit(neighbour, length of the step in strides)
  template <class Visit>
  void neighbours(int i, Visit visit) const {
    const int x = i % columns_;
    const int y = i / columns_;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const bool inside = x + dx >= 0 && y + dy >= 0 && x + dx < columns_ && y + dy < rows_;
        if ((dx != 0 || dy != 0) && inside) {
          visit(i + dy * columns_ + dx, dx != 0 && dy != 0 ? std::numbers::sqrt2_v<float> : 1.0F);
        }
      }
    }
  }

 private:
  const RouteGrid& grid_;
  int columns_;
  int rows_;
};

}  // namespace

std::optional<double> widest_value(const RouteGrid& grid, double least_m) {
  const Vertices vertices(grid);
  std::vector<float> best(vertices.size(), kNone);
  std::priority_queue<std::pair<float, int>> queue;
  const auto raise = [&](int i, float value) {
    if (value >= static_cast<float>(least_m) && value > best[static_cast<std::size_t>(i)]) {
      best[static_cast<std::size_t>(i)] = value;
      queue.emplace(value, i);
    }
  };
  for (const int i : vertices.starts()) {
    raise(i, vertices.clearance(i));
  }
  while (!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if (value < best[static_cast<std::size_t>(i)]) {
      continue;
    }
    if (vertices.in_goal(i)) {
      return static_cast<double>(value);
    }
    vertices.neighbours(i, [&, v = value](int next, float /*step*/) {
      raise(next, std::min(v, vertices.clearance(next)));
    });
  }
  return std::nullopt;
}

std::vector<Point> short_route(const RouteGrid& grid, double least_m) {
  const Vertices vertices(grid);
  std::vector<float> best(vertices.size(), std::numeric_limits<float>::infinity());
  std::vector<int> from(vertices.size(), -1);
  std::priority_queue<std::pair<float, int>, std::vector<std::pair<float, int>>, std::greater<>>
      queue;
  const auto lower = [&](int i, int before, float value) {
    if (value < best[static_cast<std::size_t>(i)]) {
      best[static_cast<std::size_t>(i)] = value;
      from[static_cast<std::size_t>(i)] = before;
      queue.emplace(value, i);
    }
  };
  const auto least = static_cast<float>(least_m);
  for (const int i : vertices.starts()) {
    if (vertices.clearance(i) >= least) {
      lower(i, -1, 0.0F);
    }
  }
  while (!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if (value > best[static_cast<std::size_t>(i)]) {
      continue;
    }
    if (vertices.in_goal(i)) {
      std::vector<Point> route;
      for (int k = i; k >= 0; k = from[static_cast<std::size_t>(k)]) {
        route.push_back(vertices.position(k));
      }
      std::reverse(route.begin(), route.end());
      return route;
    }
    vertices.neighbours(i, [&, v = value, at = i](int next, float step) {
      const float spare = vertices.clearance(next) - least;
      if (spare >= 0.0F) {
        const float share = std::max(0.0F, 1.0F - spare / static_cast<float>(kNear));
        lower(next, at, v + step * (1.0F + 3.0F * share));
      }
    });
  }
  return {};
}

}  // namespace tcert::witness
