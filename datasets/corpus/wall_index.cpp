#include "datasets/corpus/wall_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tcert {
namespace {

constexpr double kCell = 0.4;
constexpr int kRounds = 4;
constexpr double kFree = 0.001;

/// The edges of a polygon; none of a disc.
void append_edges(const Region& obstacle, std::vector<Segment>& segments) {
  if (const auto* polygon = std::get_if<Polygon>(&obstacle)) {
    const auto& vertices = polygon->vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      segments.push_back({vertices[i], vertices[(i + 1) % vertices.size()]});
    }
  }
}

/// Distance along the unit vector `u` from `origin` into the disc; infinity past it.
double distance_into(const Disc& disc, Point origin, Point u) {
  const Point to = disc.centre - origin;
  const double along = dot(u, to);
  const double across = cross(u, to);
  const double half2 = disc.radius_m * disc.radius_m - across * across;
  if (half2 <= 0.0 || along + std::sqrt(half2) < 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(along - std::sqrt(half2), 0.0);
}

/// Where the point of a segment nearest to `p` lies: 0 at its a, 1 at its b.
double share_along(const Segment& segment, Point p) {
  const Point along = segment.b - segment.a;
  return std::clamp(dot(p - segment.a, along) / dot(along, along), 0.0, 1.0);
}

Point nearest_point(const Segment& segment, Point p) {
  return segment.a + share_along(segment, p) * (segment.b - segment.a);
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
  const auto for_each_cell = [&](Point low, Point high, auto visit) {
    const std::size_t last_column = cell_number(bounds_.low.x_m, high.x_m + range_m, columns_);
    const std::size_t last_row = cell_number(bounds_.low.y_m, high.y_m + range_m, rows_);
    for (std::size_t row = cell_number(bounds_.low.y_m, low.y_m - range_m, rows_); row <= last_row;
         ++row) {
      for (std::size_t column = cell_number(bounds_.low.x_m, low.x_m - range_m, columns_);
           column <= last_column;
           ++column) {
        const Point middle{bounds_.low.x_m + (static_cast<double>(column) + 0.5) * kCell,
                           bounds_.low.y_m + (static_cast<double>(row) + 0.5) * kCell};
        visit(row * columns_ + column, middle);
      }
    }
  };
  std::vector<Segment> segments;
  std::vector<std::vector<Segment>> lists(columns_ * rows_);
  std::vector<std::vector<Disc>> disc_lists(columns_ * rows_);
  for (const Region& obstacle : world.obstacles) {
    append_edges(obstacle, segments);
    if (const auto* disc = std::get_if<Disc>(&obstacle)) {
      const Point extent{disc->radius_m, disc->radius_m};
      for_each_cell(
          disc->centre - extent, disc->centre + extent, [&](std::size_t cell, Point middle) {
            if (distance(disc->centre, middle) - disc->radius_m <= within) {
              disc_lists[cell].push_back(*disc);
            }
          });
    }
  }
  for (const Segment& s : segments) {
    const Point low{std::min(s.a.x_m, s.b.x_m), std::min(s.a.y_m, s.b.y_m)};
    const Point high{std::max(s.a.x_m, s.b.x_m), std::max(s.a.y_m, s.b.y_m)};
    for_each_cell(low, high, [&](std::size_t cell, Point middle) {
      if (distance(nearest_point(s, middle), middle) <= within) {
        lists[cell].push_back(s);
      }
    });
  }
  cells_.reserve(lists.size());
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(near_.size());
    const auto first_disc = static_cast<std::uint32_t>(near_discs_.size());
    near_.insert(near_.end(), lists[i].begin(), lists[i].end());
    near_discs_.insert(near_discs_.end(), disc_lists[i].begin(), disc_lists[i].end());
    cells_.push_back({first,
                      static_cast<std::uint32_t>(near_.size()),
                      first_disc,
                      static_cast<std::uint32_t>(near_discs_.size())});
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
  for (std::size_t i = cell.first_disc; i < cell.last_disc; ++i) {
    nearest = std::min(nearest, distance_into(near_discs_[i], origin, u));
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
    for (std::size_t i = cell.first_disc; i < cell.last_disc; ++i) {
      const Point out = centre - near_discs_[i].centre;
      const double from_centre = norm(out);
      const double lacking = radius + near_discs_[i].radius_m - from_centre;
      if (lacking <= 0.0 || from_centre <= 0.0) {
        continue;
      }
      deepest = std::max(deepest, lacking);
      if (round < kRounds) {
        centre = centre + (lacking / from_centre) * out;
      }
    }
    if (deepest == 0.0) {
      break;
    }
  }
  return {centre, deepest <= kFree};
}

double WallIndex::distance_from(Point p) const noexcept {
  const Cell cell = cell_at(p);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = cell.first; i < cell.last; ++i) {
    nearest = std::min(nearest, distance(nearest_point(near_[i], p), p));
  }
  for (std::size_t i = cell.first_disc; i < cell.last_disc; ++i) {
    nearest = std::min(nearest, distance(near_discs_[i].centre, p) - near_discs_[i].radius_m);
  }
  return nearest;
}

std::size_t WallIndex::walls_within(Point p,
                                    double distance_m,
                                    std::span<NearWall> walls) const noexcept {
  const Cell cell = cell_at(p);
  std::size_t found = 0;
  const auto add = [&](const NearWall& wall) {
    if (wall.distance_m < distance_m) {
      if (found < walls.size()) {
        walls[found] = wall;
      }
      ++found;
    }
  };
  for (std::size_t i = cell.first; i < cell.last; ++i) {
    const double share = share_along(near_[i], p);
    const Point nearest = near_[i].a + share * (near_[i].b - near_[i].a);
    const bool at_corner = share == 0.0 || share == 1.0;
    add({nearest, distance(nearest, p), at_corner ? 0.0 : std::numeric_limits<double>::infinity()});
  }
  for (std::size_t i = cell.first_disc; i < cell.last_disc; ++i) {
    const Disc& disc = near_discs_[i];
    const Point out = p - disc.centre;
    const double apart = norm(out);
    add({disc.centre + (disc.radius_m / apart) * out, apart - disc.radius_m, disc.radius_m});
  }
  return found;
}

}  // namespace tcert
