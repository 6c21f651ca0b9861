#pragma once
/// \file
/// What the witness asks of S and G beside whether a point lies in them.

#include <tcert/region.hpp>

namespace tcert::witness {

struct Box {
  Point low;
  Point high;
};

[[nodiscard]] double distance_to_segment(Point p, Point a, Point b) noexcept;

[[nodiscard]] Box bounding_box(const Region& region) noexcept;

/// True if the whole of a box lies in the region; of a polygon it may say no of a box whose
/// circumscribed disc touches an edge. O(vertices).
[[nodiscard]] bool covers(const Region& region, const Box& box) noexcept;

/// True if the two have a point in common. O(product of the vertices).
[[nodiscard]] bool overlap(const Region& a, const Region& b) noexcept;

/// `p` if it lies in the region, else a point of it that is within a micrometre of the nearest, as
/// long as there is one so near to its border. O(vertices).
[[nodiscard]] Point nearest_within(const Region& region, Point p) noexcept;

}  // namespace tcert::witness
