#pragma once
/// \file
/// Exact distance to the nearest obstacle of a world.

#include <cstddef>
#include <cstdint>
#include <tcert/region.hpp>
#include <vector>

#include "datasets/world.hpp"

namespace tcert::study {

/// Discs and polygon edges in square buckets. Immutable; safe for concurrent use.
class ObstacleDistance {
 public:
  explicit ObstacleDistance(const World& world);

  /// Distance to the nearest disc, polygon edge or side of the bounds; 0 in a disc and outside of
  /// the bounds. Inside a polygon it is the distance to an edge: who starts outside of all and
  /// moves by less than this never gets there. O(1) where obstacles are spread evenly.
  [[nodiscard]] double at(Point p) const noexcept;

 private:
  struct Edge {
    Point a;
    Point b;
  };
  struct Bucket {
    std::uint32_t first_disc = 0;
    std::uint32_t first_edge = 0;
  };

  [[nodiscard]] double nearest_in(std::size_t column, std::size_t row, Point p) const noexcept;

  Bounds bounds_;
  double bucket_m_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<Bucket> buckets_;  // one more than there are: where the last one ends
  std::vector<Disc> discs_;      // bucket by bucket
  std::vector<Edge> edges_;
};

}  // namespace tcert::study
