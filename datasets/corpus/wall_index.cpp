#include "datasets/corpus/wall_index.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tcert {
namespace {

constexpr double kCell = 0.4;
constexpr int kRounds = 4;
constexpr double kFree = 0.001;

std::vector<Segment> segments_of(const World& world) {
  std::vector<Segment> segments;
  for (const Region& obstacle : world.obstacles) {
    const auto* polygon = std::get_if<Polygon>(&obstacle);
    if (polygon == nullptr) {
      throw std::invalid_argument("wall index: expected polygons only, found a disc");
    }
    const auto& vertices = polygon->vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      segments.push_back({vertices[i], vertices[(i + 1) % vertices.size()]});
    }
  }
  return segments;
}

Point nearest_point(const Segment& segment, Point p) {
  const Point along = segment.b - segment.a;
  const double t = std::clamp(dot(p - segment.a, along) / dot(along, along), 0.0, 1.0);
  return segment.a + t * along;
}

std::size_t cell_number(double from, double value, std::size_t count) {
  const double number = std::floor((value - from) / kCell);
  return static_cast<std::size_t>(std::clamp(number, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

WallIndex::WallIndex(const World& world, double range_m)
    : bounds_(world.bounds),
      columns_(static_cast<std::size_t>(
          std::ceil((world.bounds.high.x_m - world.bounds.low.x_m) / kCell))),
      rows_(static_cast<std::size_t>(
          std::ceil((world.bounds.high.y_m - world.bounds.low.y_m) / kCell))) {
  const double within = range_m + kCell * std::sqrt(0.5);
  std::vector<std::vector<Segment>> lists(columns_ * rows_);
  for (const Segment& s : segments_of(world)) {
    const Point low{std::min(s.a.x_m, s.b.x_m) - range_m, std::min(s.a.y_m, s.b.y_m) - range_m};
    const Point high{std::max(s.a.x_m, s.b.x_m) + range_m, std::max(s.a.y_m, s.b.y_m) + range_m};
    const std::size_t last_column = cell_number(bounds_.low.x_m, high.x_m, columns_);
    const std::size_t last_row = cell_number(bounds_.low.y_m, high.y_m, rows_);
    for (std::size_t row = cell_number(bounds_.low.y_m, low.y_m, rows_); row <= last_row; ++row) {
      for (std::size_t column = cell_number(bounds_.low.x_m, low.x_m, columns_);
           column <= last_column;
           ++column) {
        const Point middle{bounds_.low.x_m + (static_cast<double>(column) + 0.5) * kCell,
                           bounds_.low.y_m + (static_cast<double>(row) + 0.5) * kCell};
        if (distance(nearest_point(s, middle), middle) <= within) {
          lists[row * columns_ + column].push_back(s);
        }
      }
    }
  }
  cells_.reserve(lists.size());
  for (const auto& list : lists) {
    const auto first = static_cast<std::uint32_t>(near_.size());
    near_.insert(near_.end(), list.begin(), list.end());
    cells_.push_back({first, static_cast<std::uint32_t>(near_.size())});
  }
}

WallIndex::Cell WallIndex::cell_at(Point p) const noexcept {
  return cells_[cell_number(bounds_.low.y_m, p.y_m, rows_) * columns_ +
                cell_number(bounds_.low.x_m, p.x_m, columns_)];
}

double WallIndex::cast(Point standpoint, Point origin, Point u, double reach) const noexcept {
  const Cell cell = cell_at(standpoint);
  double nearest = reach;
  for (std::size_t i = cell.first; i < cell.last; ++i) {
    const Point a = near_[i].a - origin;
    const Point b = near_[i].b - origin;
    const double side_a = cross(u, a);
    const double side_b = cross(u, b);
    if ((side_a < 0.0) == (side_b < 0.0)) {
      continue;
    }
    const double t = side_a / (side_a - side_b);
    const double ahead = dot(u, a) + t * dot(u, b - a);
    if (ahead >= 0.0) {
      nearest = std::min(nearest, ahead);
    }
  }
  return nearest;
}

std::pair<Point, bool> WallIndex::pushed_out(Point centre, double radius) const noexcept {
  const Cell cell = cell_at(centre);
  double deepest = 0.0;
  for (int round = 0; round <= kRounds; ++round) {
    deepest = 0.0;
    for (std::size_t i = cell.first; i < cell.last; ++i) {
      const Point out = centre - nearest_point(near_[i], centre);
      const double gap = norm(out);
      if (gap >= radius || gap <= 0.0) {
        continue;
      }
      deepest = std::max(deepest, radius - gap);
      if (round < kRounds) {
        centre = centre + ((radius - gap) / gap) * out;
      }
    }
    if (deepest == 0.0) {
      break;
    }
  }
  return {centre, deepest <= kFree};
}

}  // namespace tcert
