#pragma once
/// \file
/// What the witness asks of S and G beside whether a point lies in them.

#include <tcert/region.hpp>
#include <vector>

namespace tcert::witness {

struct Box {
  Point low;
  Point high;
};

[[nodiscard]] Box bounding_box(const Region& region) noexcept;

/// The part of a region that boxes of one height may meet: of a polygon the edges near them, so
/// that a polygon of many corners costs a box no more than one of few.
class RowOfRegion {
 public:
  /// Of boxes round `middle_y_m`, with half a diagonal of `half_diagonal_m`. The region must
  /// outlive it. O(vertices).
  RowOfRegion(const Region& region, double middle_y_m, double half_diagonal_m);

  /// True if the whole of such a box lies in the region; of a polygon it may say no of a box whose
  /// circumscribed disc touches an edge. O(edges near the row).
  [[nodiscard]] bool covers(const Box& box) const noexcept;

 private:
  struct Edge {
    Point from;
    Point to;
  };
  const Disc* disc_;
  std::vector<Edge> near_;
};

/// `p` if it lies in the region, else a point of it that is within a micrometre of the nearest, as
/// long as there is one so near to its border. O(vertices).
[[nodiscard]] Point nearest_within(const Region& region, Point p) noexcept;

}  // namespace tcert::witness
