#include <algorithm>
#include <cstddef>
#include <optional>
#include <terrain/convex_polygon.hpp>
#include <terrain/obstacle_map.hpp>
#include <terrain/triangulation.hpp>
#include <utility>

namespace tcert::terrain {
namespace {

constexpr double kBorderCentre = 1.0;  // cells beyond the border
constexpr double kChildCentre = 0.8;   // of the way through the parent

[[nodiscard]] std::vector<Position> corners_of(const std::vector<Position>& polygon,
                                               const Triangle& t) {
  return {polygon[t[0]], polygon[t[1]], polygon[t[2]]};
}

struct Root {
  std::size_t triangle = 0;
  std::size_t edge = 0;
};

/// Of a border piece the triangle with the longest edge on the border, else the largest; none if
/// there is no such edge, or no triangle.
[[nodiscard]] std::optional<Root> root_of(const PseudoObstacle& obstacle,
                                          const std::vector<Triangle>& triangles) {
  if (triangles.empty()) {
    return std::nullopt;
  }
  const std::vector<Position>& polygon = obstacle.polygon;
  const auto [low, high] = box_round(polygon);
  std::optional<Root> root;
  double best = -1.0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::vector<Position> v = corners_of(polygon, triangles[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Position& a = v[k];
      const Position& b = v[(k + 1) % 3];
      double merit = doubled_area(v[0], v[1], v[2]);
      if (obstacle.on_border) {
        const bool on_side = (a.x() == b.x() && (a.x() == low.x() || a.x() == high.x())) ||
                             (a.y() == b.y() && (a.y() == low.y() || a.y() == high.y()));
        // An edge of the polygon itself, not a diagonal: its corners follow one another.
        const bool is_side = (triangles[t][k] + 1) % polygon.size() == triangles[t][(k + 1) % 3];
        merit = on_side && is_side ? (b - a).norm() : -1.0;
      }
      if (merit > best) {
        best = merit;
        root = {t, k};
      }
    }
  }
  return root;
}

/// The triangle, and beyond its edge v0-v1 the centre from which the map sees it.
[[nodiscard]] std::vector<Position> core_of(const std::vector<Position>& v,
                                            const Position& centre) {
  return {centre, v[1], v[2], v[0]};
}

/// Far into the parent, as far as the core stays convex.
[[nodiscard]] Position centre_within(const std::vector<Position>& parent,
                                     const std::vector<Position>& v) {
  const Position middle = 0.5 * (v[0] + v[1]);
  const Position exit = exit_of(middle, (middle - v[2]).normalized(), parent);
  Position centre;
  double share = kChildCentre;
  do {
    centre = middle + share * (exit - middle);
    share *= 0.5;
  } while (!is_convex(core_of(v, centre)) && share > 1e-3);
  return centre;
}

}  // namespace

ObstacleMap::ObstacleMap(const std::vector<PseudoObstacle>& obstacles,
                         const MapParameters& parameters)
    : parameters_(parameters) {
  for (const PseudoObstacle& obstacle : obstacles) {
    add(obstacle);
  }
}

void ObstacleMap::add(const PseudoObstacle& obstacle) {
  const std::vector<Position>& polygon = obstacle.polygon;
  const std::vector<Triangle> triangles = ear_clipping(polygon);
  const std::optional<Root> root = root_of(obstacle, triangles);
  if (!root) {
    ++left_out_;
    return;
  }
  const std::vector<TreeTriangle> tree = triangle_tree(triangles, root->triangle);
  std::vector<TriangleMap> maps;
  for (std::size_t t = 0; t < tree.size(); ++t) {
    std::vector<Position> v = corners_of(polygon, tree[t].corners);
    const bool is_root = t + 1 == tree.size();
    if (is_root && !obstacle.on_border) {
      maps.emplace_back(v, collar_round(v, parameters_.beta_reach, {}), parameters_);
      continue;
    }
    Position centre;
    if (is_root) {
      std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(root->edge), v.end());
      centre = 0.5 * (v[0] + v[1]) + kBorderCentre * left_of(v[0], v[1]).normal;
    } else {
      centre = centre_within(corners_of(polygon, tree[tree[t].parent].corners), v);
    }
    const std::vector<Position> core = core_of(v, centre);
    std::vector<Position> collar = collar_round(core, parameters_.beta_reach, {0, 3});
    for (std::size_t later = t + 1; later < tree.size(); ++later) {
      if (later == tree[t].parent) {
        continue;
      }
      if (const auto plane = separating(core, corners_of(polygon, tree[later].corners))) {
        collar = clipped(collar, plane->normal, plane->offset);
      }
    }
    if (collar.size() < 3 || !is_convex(core)) {
      ++left_out_;
      return;
    }
    maps.emplace_back(v, std::move(collar), centre, parameters_);
  }
  roots_.push_back({maps.back().centre(), maps.back().radius()});
  maps_.insert(maps_.end(), maps.begin(), maps.end());
}

Mapped ObstacleMap::map(const Position& x) const {
  Mapped total;
  total.x = x;
  for (const TriangleMap& triangle : maps_) {
    if (triangle.outside(total.x) || triangle.beta(total.x).value >= parameters_.beta_reach) {
      continue;
    }
    const Mapped one = triangle.map(total.x);
    if (one.sigma > 0.0) {
      total.x = one.x;
      total.jacobian = one.jacobian * total.jacobian;
    }
  }
  return total;
}

}  // namespace tcert::terrain
