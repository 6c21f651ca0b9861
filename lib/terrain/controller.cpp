#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <terrain/controller.hpp>
#include <terrain/pursuit.hpp>

namespace tcert::terrain {
namespace {

/// The part of the ground whose outline holds `p`, simplified; none if there is none.
[[nodiscard]] std::optional<Outline> outline_round(const Grid& grid,
                                                   const CellSet& ground,
                                                   const Position& p,
                                                   double tolerance) {
  for (Outline& part : outlines(grid, ground)) {
    const Box box = box_round(part.ring);
    bool inside = false;
    for (std::size_t k = 0; k < part.ring.size(); ++k) {
      const Position a = position(part.ring[k]);
      const Position b = position(part.ring[(k + 1) % part.ring.size()]);
      if (distance_to_segment(p, a, b) < 1e-9) {
        inside = true;
        break;
      }
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        inside = !inside;
      }
    }
    if (!inside || (p.array() < box.low.array()).any() || (p.array() > box.high.array()).any()) {
      continue;
    }
    part.ring = simplified(grid, ground, part.ring, tolerance);
    for (std::vector<Cell>& hole : part.holes) {
      hole = simplified(grid, ground, hole, tolerance);
    }
    return std::move(part);
  }
  return std::nullopt;
}

}  // namespace

ReactiveWay reactive_way(const Grid& grid,
                         const CellSet& ground,
                         const Position& from,
                         const Position& to,
                         const ControllerOptions& options) {
  ReactiveWay way;
  way.path.push_back(from);
  const auto outline = outline_round(grid, ground, from, options.simplification);
  if (!outline) {
    return way;
  }
  const Box box = box_round(outline->ring);
  const std::vector<Position> corners{
      box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
  const ObstacleMap map(pseudo_obstacles(*outline), MapParameters{});
  way.triangles = map.triangles();
  const Position goal = map.map(to).x;
  Position x = from;
  for (int frame = 0; frame < options.most_frames; ++frame) {
    if ((x - to).norm() < 1.0) {
      way.arrived = true;
      return way;
    }
    const Mapped here = map.map(x);
    const std::vector<Position> free = eroded(
        power_cell({here.x, options.robot_radius}, map.roots(), corners), options.robot_radius);
    if (frame == 0) {
      way.free_space = free;
    }
    if (free.size() < 3 || std::abs(here.jacobian.determinant()) < 1e-12) {
      return way;
    }
    const Eigen::Vector2d v = nearest_point(free, goal) - here.x;
    const Eigen::Vector2d u = here.jacobian.inverse() * v;
    if (!u.allFinite() || u.norm() < options.standstill) {
      return way;
    }
    Eigen::Vector2d step = options.gain * u;
    step *= std::min(1.0, options.longest_step / step.norm());
    int halvings = 0;
    while (!stays_on_ground(grid, ground, x, x + step) && halvings < 6) {
      step *= 0.5;
      ++halvings;
    }
    if (halvings == 6) {
      return way;
    }
    x += step;
    way.path.push_back(x);
    // Going to and fro is standing still too.
    const std::size_t frames = options.standstill_frames;
    if (way.path.size() > frames && (x - way.path[way.path.size() - 1 - frames]).norm() < 1.0) {
      return way;
    }
  }
  return way;
}

}  // namespace tcert::terrain
