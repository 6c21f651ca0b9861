#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tcert/segment.hpp>
#include <witness/border_cells.hpp>
#include <witness/region_shape.hpp>

namespace tcert::witness {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance_to_box(Point p, const Box& box) {
  return norm({std::max({box.low.x_m - p.x_m, 0.0, p.x_m - box.high.x_m}),
               std::max({box.low.y_m - p.y_m, 0.0, p.y_m - box.high.y_m})});
}

double segment_to_box(Point a, Point b, const Box& box) {
  double least = std::min(distance_to_box(a, box), distance_to_box(b, box));
  double left = -kInfinity;
  double right = -kInfinity;
  for (const Point corner :
       {box.low, Point{box.high.x_m, box.low.y_m}, box.high, Point{box.low.x_m, box.high.y_m}}) {
    least = std::min(least, distance_to_segment(corner, a, b));
    const double side = cross(b - a, corner - a);
    left = std::max(left, side);
    right = std::max(right, -side);
  }
  const bool meets = left >= 0.0 && right >= 0.0 && std::max(a.x_m, b.x_m) >= box.low.x_m &&
                     std::min(a.x_m, b.x_m) <= box.high.x_m &&
                     std::max(a.y_m, b.y_m) >= box.low.y_m &&
                     std::min(a.y_m, b.y_m) <= box.high.y_m;
  return meets ? 0.0 : least;
}

bool touches_border(const FreeCells& cells) {
  const Lattice& lattice = cells.lattice();
  bool touches = false;
  for (int ix = 0; ix < lattice.columns; ++ix) {
    touches = touches || cells.is_free(ix, 0) || cells.is_free(ix, lattice.rows - 1);
  }
  for (int iy = 0; iy < lattice.rows; ++iy) {
    touches = touches || cells.is_free(0, iy) || cells.is_free(lattice.columns - 1, iy);
  }
  return touches;
}

}  // namespace

BorderCells::BorderCells(const FreeCells& cells)
    : lattice_(cells.lattice()),
      columns_(static_cast<std::size_t>(lattice_.rows)),
      cut_(touches_border(cells)) {
  for (int iy = 0; iy < lattice_.rows; ++iy) {
    const auto here = cells.row(iy);
    const auto below = cells.row(std::max(iy - 1, 0));
    const auto above = cells.row(std::min(iy + 1, lattice_.rows - 1));
    const auto any = [&](std::size_t w) { return here[w] | below[w] | above[w]; };
    for (std::size_t w = 0; w < here.size(); ++w) {
      const std::uint64_t left = w > 0 ? any(w - 1) >> 63U : 0U;
      const std::uint64_t right = w + 1 < here.size() ? any(w + 1) << 63U : 0U;
      std::uint64_t bits = (any(w) | any(w) << 1U | left | any(w) >> 1U | right) & ~here[w];
      for (; bits != 0; bits &= bits - 1) {
        columns_[static_cast<std::size_t>(iy)].push_back(static_cast<int>(64 * w) +
                                                         std::countr_zero(bits));
      }
    }
  }
}

double BorderCells::distance_m(Point a, Point b, double most_m) const {
  double least_m = most_m;
  const int first = std::max(0, lattice_.row_of(std::min(a.y_m, b.y_m) - most_m) - 1);
  const int last =
      std::min(lattice_.rows - 1, lattice_.row_of(std::max(a.y_m, b.y_m) + most_m) + 1);
  const int left = lattice_.column_of(std::min(a.x_m, b.x_m) - most_m) - 1;
  const int right = lattice_.column_of(std::max(a.x_m, b.x_m) + most_m) + 1;
  for (int iy = first; iy <= last; ++iy) {
    const std::vector<int>& row = columns_[static_cast<std::size_t>(iy)];
    for (auto ix = std::lower_bound(row.begin(), row.end(), left); ix != row.end() && *ix <= right;
         ++ix) {
      least_m = std::min(
          least_m,
          segment_to_box(a, b, {lattice_.corner(*ix, iy), lattice_.corner(*ix + 1, iy + 1)}));
    }
  }
  return least_m;
}

}  // namespace tcert::witness
