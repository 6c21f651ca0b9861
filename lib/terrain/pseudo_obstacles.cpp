#include <algorithm>
#include <array>
#include <terrain/pseudo_obstacles.hpp>
#include <utility>

namespace tcert::terrain {
namespace {

[[nodiscard]] std::vector<Position> positions_of(const std::vector<Cell>& ring) {
  std::vector<Position> positions;
  positions.reserve(ring.size());
  for (const Cell c : ring) {
    positions.push_back(position(c));
  }
  return positions;
}

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
  result.reserve(between.size());
  for (const auto& [s, corner] : between) {
    result.push_back(corner);
  }
  return result;
}

}  // namespace

Box box_round(const std::vector<Position>& points) {
  Box box{points.front(), points.front()};
  for (const Position& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Box box_round(const std::vector<Cell>& ring) { return box_round(positions_of(ring)); }

std::vector<PseudoObstacle> pseudo_obstacles(const Outline& outline) {
  std::vector<PseudoObstacle> obstacles;
  const std::vector<Position> ring = positions_of(outline.ring);
  const Box box = box_round(ring);
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
    const std::vector<Position> corners = corners_between(box, ring[from], ring[to % ring.size()]);
    if (to - from < 2 && corners.empty()) {
      continue;  // along one side of the box
    }
    PseudoObstacle obstacle;
    obstacle.on_border = true;
    for (std::size_t k = to + 1; k-- > from;) {
      obstacle.polygon.push_back(ring[k % ring.size()]);
    }
    obstacle.polygon.insert(obstacle.polygon.end(), corners.begin(), corners.end());
    obstacles.push_back(std::move(obstacle));
  }
  for (const std::vector<Cell>& hole : outline.holes) {
    std::vector<Position> polygon = positions_of(hole);
    std::reverse(polygon.begin(), polygon.end());
    obstacles.push_back({std::move(polygon), false});
  }
  return obstacles;
}

}  // namespace tcert::terrain
