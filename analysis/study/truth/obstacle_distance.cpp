#include "analysis/study/truth/obstacle_distance.hpp"

#include <algorithm>
#include <cmath>
#include <tcert/segment.hpp>

#include "datasets/worlds/region_distance.hpp"

namespace tcert::study {
namespace {

constexpr double kMostBuckets = 1'000'000.0;

std::size_t place(double from, double value, double step, std::size_t count) {
  const double number = std::floor((value - from) / step);
  return static_cast<std::size_t>(std::clamp(number, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

ObstacleDistance::ObstacleDistance(const World& world) : bounds_(world.bounds) {
  std::vector<Disc> discs;
  std::vector<Edge> edges;
  for (const Region& obstacle : world.obstacles) {
    if (const auto* disc = std::get_if<Disc>(&obstacle)) {
      discs.push_back(*disc);
      continue;
    }
    const auto& v = std::get<Polygon>(obstacle).vertices;
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
      edges.push_back({v[j], v[i]});
    }
  }
  const Point size = bounds_.high - bounds_.low;
  const double wanted =
      std::clamp(static_cast<double>(discs.size() + edges.size()), 16.0, kMostBuckets);
  bucket_m_ = std::max(std::sqrt(size.x_m * size.y_m / wanted),
                       std::max(size.x_m, size.y_m) / std::sqrt(kMostBuckets));
  columns_ = static_cast<std::size_t>(std::ceil(size.x_m / bucket_m_));
  rows_ = static_cast<std::size_t>(std::ceil(size.y_m / bucket_m_));

  std::vector<std::vector<std::uint32_t>> disc_lists(columns_ * rows_);
  std::vector<std::vector<std::uint32_t>> edge_lists(columns_ * rows_);
  const auto list = [&](auto& lists, Point low, Point high, std::size_t index) {
    const std::size_t last_column = place(bounds_.low.x_m, high.x_m, bucket_m_, columns_);
    const std::size_t last_row = place(bounds_.low.y_m, high.y_m, bucket_m_, rows_);
    for (std::size_t row = place(bounds_.low.y_m, low.y_m, bucket_m_, rows_); row <= last_row;
         ++row) {
      for (std::size_t column = place(bounds_.low.x_m, low.x_m, bucket_m_, columns_);
           column <= last_column;
           ++column) {
        lists[row * columns_ + column].push_back(static_cast<std::uint32_t>(index));
      }
    }
  };
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Extent extent = extent_of(Region(discs[i]));
    list(disc_lists, extent.low, extent.high, i);
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b] = edges[i];
    list(edge_lists,
         {std::min(a.x_m, b.x_m), std::min(a.y_m, b.y_m)},
         {std::max(a.x_m, b.x_m), std::max(a.y_m, b.y_m)},
         i);
  }
  buckets_.reserve(disc_lists.size() + 1);
  for (std::size_t k = 0; k < disc_lists.size(); ++k) {
    buckets_.push_back(
        {static_cast<std::uint32_t>(discs_.size()), static_cast<std::uint32_t>(edges_.size())});
    for (const std::uint32_t i : disc_lists[k]) {
      discs_.push_back(discs[i]);
    }
    for (const std::uint32_t i : edge_lists[k]) {
      edges_.push_back(edges[i]);
    }
  }
  buckets_.push_back(
      {static_cast<std::uint32_t>(discs_.size()), static_cast<std::uint32_t>(edges_.size())});
}

double ObstacleDistance::nearest_in(std::size_t column, std::size_t row, Point p) const noexcept {
  const std::size_t k = row * columns_ + column;
  double least = HUGE_VAL;
  for (std::size_t i = buckets_[k].first_disc; i < buckets_[k + 1].first_disc; ++i) {
    least = std::min(least, distance(p, discs_[i].centre) - discs_[i].radius_m);
  }
  for (std::size_t i = buckets_[k].first_edge; i < buckets_[k + 1].first_edge; ++i) {
    least = std::min(least, distance_to_segment(p, edges_[i].a, edges_[i].b));
  }
  return least;
}

double ObstacleDistance::at(Point p) const noexcept {
  double least = std::min({p.x_m - bounds_.low.x_m,
                           p.y_m - bounds_.low.y_m,
                           bounds_.high.x_m - p.x_m,
                           bounds_.high.y_m - p.y_m});
  if (!(least > 0.0)) {
    return 0.0;
  }
  const std::size_t column = place(bounds_.low.x_m, p.x_m, bucket_m_, columns_);
  const std::size_t row = place(bounds_.low.y_m, p.y_m, bucket_m_, rows_);
  const double u = p.x_m - bounds_.low.x_m - static_cast<double>(column) * bucket_m_;
  const double v = p.y_m - bounds_.low.y_m - static_cast<double>(row) * bucket_m_;
  const double to_edge = std::min({u, v, bucket_m_ - u, bucket_m_ - v});
  for (std::size_t ring = 0;; ++ring) {
    // Nothing in this ring or further out is nearer than its inner edge.
    if (ring > 0 && static_cast<double>(ring - 1) * bucket_m_ + to_edge >= least) {
      break;
    }
    const std::size_t first_column = column >= ring ? column - ring : 0;
    const std::size_t last_column = std::min(column + ring, columns_ - 1);
    const std::size_t first_row = row >= ring ? row - ring : 0;
    const std::size_t last_row = std::min(row + ring, rows_ - 1);
    for (std::size_t y = first_row; y <= last_row; ++y) {
      const bool whole_row = y + ring == row || y == row + ring;
      for (std::size_t x = first_column; x <= last_column; ++x) {
        if (whole_row || x + ring == column || x == column + ring) {
          least = std::min(least, nearest_in(x, y, p));
        }
      }
    }
  }
  return std::max(least, 0.0);
}

}  // namespace tcert::study
