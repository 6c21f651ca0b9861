#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <terrain/implicit.hpp>
#include <terrain/obstacle_map.hpp>
#include <terrain/triangulation.hpp>

namespace tcert::terrain {
namespace {

constexpr double kBorderCentre = 1.0;  // cells beyond the border
constexpr double kChildCentre = 0.8;   // of the way through the parent

[[nodiscard]] bool touches(const Box& box, const Position& p) {
  return p.x() == box.low.x() || p.x() == box.high.x() || p.y() == box.low.y() ||
         p.y() == box.high.y();
}

/// Counter-clockwise way along the box from its lowest corner to a point of it.
[[nodiscard]] double perimeter_at(const Box& box, const Position& p) {
  const double w = box.high.x() - box.low.x();
  const double h = box.high.y() - box.low.y();
  if (p.y() == box.low.y()) {
    return p.x() - box.low.x();
  }
  if (p.x() == box.high.x()) {
    return w + p.y() - box.low.y();
  }
  if (p.y() == box.high.y()) {
    return w + h + box.high.x() - p.x();
  }
  return 2.0 * w + h + box.high.y() - p.y();
}

/// The box's corners strictly between a and b, counter-clockwise.
[[nodiscard]] std::vector<Position> corners_between(const Box& box,
                                                    const Position& a,
                                                    const Position& b) {
  const double w = box.high.x() - box.low.x();
  const double h = box.high.y() - box.low.y();
  const double round = 2.0 * (w + h);
  const std::array<std::pair<double, Position>, 4> corners{
      {{0.0, box.low},
       {w, {box.high.x(), box.low.y()}},
       {w + h, box.high},
       {2.0 * w + h, {box.low.x(), box.high.y()}}}};
  const double from = perimeter_at(box, a);
  double to = perimeter_at(box, b);
  to += to <= from ? round : 0.0;
  std::vector<std::pair<double, Position>> between;
  for (const auto& [at, corner] : corners) {
    for (const double s : {at, at + round}) {
      if (s > from && s < to) {
        between.emplace_back(s, corner);
      }
    }
  }
  std::sort(between.begin(), between.end(), [](const auto& x, const auto& y) {
    return x.first < y.first;
  });
  std::vector<Position> result;
  for (const auto& [s, corner] : between) {
    result.push_back(corner);
  }
  return result;
}

/// Line a-b as normal . z <= offset for what lies to its left.
struct HalfPlane {
  Eigen::Vector2d normal{0.0, 0.0};
  double offset = 0.0;
};

[[nodiscard]] HalfPlane left_of(const Position& a, const Position& b) {
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d right(along.y(), -along.x());
  return {right, right.dot(a)};
}

/// A half plane that holds convex `kept` and not the inside of convex `other`; none if they
/// overlap.
[[nodiscard]] std::optional<HalfPlane> separating(const std::vector<Position>& kept,
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

[[nodiscard]] bool is_convex(const std::vector<Position>& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    if (!(doubled_area(polygon[k],
                       polygon[(k + 1) % polygon.size()],
                       polygon[(k + 2) % polygon.size()]) > 1e-12)) {
      return false;
    }
  }
  return true;
}

/// Where the ray from `from` along `direction` leaves the triangle it is in.
[[nodiscard]] Position exit_of(const Position& from,
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

[[nodiscard]] std::vector<Position> corners_of(const std::vector<Position>& polygon,
                                               const Triangle& t) {
  return {polygon[t[0]], polygon[t[1]], polygon[t[2]]};
}

}  // namespace

Box box_round(const std::vector<Cell>& ring) {
  Box box{position(ring.front()), position(ring.front())};
  for (const Cell c : ring) {
    box.low = box.low.cwiseMin(position(c));
    box.high = box.high.cwiseMax(position(c));
  }
  return box;
}

std::vector<PseudoObstacle> pseudo_obstacles(const Outline& outline) {
  std::vector<PseudoObstacle> obstacles;
  const Box box = box_round(outline.ring);
  std::vector<Position> ring;
  for (const Cell c : outline.ring) {
    ring.push_back(position(c));
  }
  std::vector<std::size_t> touching;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (touches(box, ring[k])) {
      touching.push_back(k);
    }
  }
  for (std::size_t t = 0; t < touching.size(); ++t) {
    const std::size_t from = touching[t];
    std::size_t to = touching[(t + 1) % touching.size()];
    to += to <= from ? ring.size() : 0;
    if (to - from < 2 && corners_between(box, ring[from], ring[to % ring.size()]).empty()) {
      continue;  // along one side of the box
    }
    PseudoObstacle obstacle;
    obstacle.on_border = true;
    for (std::size_t k = to + 1; k-- > from;) {
      obstacle.polygon.push_back(ring[k % ring.size()]);
    }
    for (const Position& corner : corners_between(box, ring[from], ring[to % ring.size()])) {
      obstacle.polygon.push_back(corner);
    }
    obstacles.push_back(std::move(obstacle));
  }
  for (const std::vector<Cell>& hole : outline.holes) {
    PseudoObstacle obstacle;
    for (std::size_t k = hole.size(); k-- > 0;) {
      obstacle.polygon.push_back(position(hole[k]));
    }
    obstacles.push_back(std::move(obstacle));
  }
  return obstacles;
}

std::vector<Position> collar_round(const std::vector<Position>& core,
                                   double width,
                                   const std::vector<std::size_t>& fixed) {
  Position low = core.front();
  Position high = core.front();
  for (const Position& p : core) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
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
  if (triangles.empty()) {
    ++left_out_;
    return;
  }
  // The root: of a border piece the triangle with the longest edge on the border, else the largest.
  std::size_t root = 0;
  std::size_t root_edge = 0;
  double best = -1.0;
  Position low = polygon.front();
  Position high = polygon.front();
  for (const Position& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
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
        root = t;
        root_edge = k;
      }
    }
  }
  if (best < 0.0) {
    ++left_out_;
    return;
  }
  const std::vector<TreeTriangle> tree = triangle_tree(triangles, root);
  std::vector<TriangleMap> maps;
  std::optional<Disc> disc;
  for (std::size_t t = 0; t < tree.size(); ++t) {
    std::vector<Position> v = corners_of(polygon, tree[t].corners);
    const bool is_root = t + 1 == tree.size();
    if (is_root && !obstacle.on_border) {
      maps.emplace_back(v, collar_round(v, parameters_.beta_reach, {}), parameters_);
      disc = Disc{maps.back().centre(), maps.back().radius()};
      continue;
    }
    Position centre;
    std::vector<Position> core;
    if (is_root) {
      std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(root_edge), v.end());
      const HalfPlane border = left_of(v[0], v[1]);
      centre = 0.5 * (v[0] + v[1]) + kBorderCentre * border.normal;
      core = {centre, v[1], v[2], v[0]};
      disc = Disc{centre, 0.0};
    } else {
      const Position middle = 0.5 * (v[0] + v[1]);
      const std::vector<Position> parent = corners_of(polygon, tree[tree[t].parent].corners);
      const Position exit = exit_of(middle, (middle - v[2]).normalized(), parent);
      double share = kChildCentre;
      do {
        centre = middle + share * (exit - middle);
        core = {centre, v[1], v[2], v[0]};
        share *= 0.5;
      } while (!is_convex(core) && share > 1e-3);
    }
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
  maps_.insert(maps_.end(), maps.begin(), maps.end());
  roots_.push_back(*disc);
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
