#pragma once
/// \file
/// The walls of a world as segments and circles, found by where the robot stands.

#include <cstddef>
#include <cstdint>
#include <span>
#include <tcert/geometry.hpp>
#include <tcert/region.hpp>
#include <utility>
#include <vector>

#include "datasets/world.hpp"

namespace tcert {

struct Segment {
  Point a;
  Point b;
};

/// A wall, by its point nearest to where it was asked from.
struct NearWall {
  Point nearest;
  double distance_m = 0.0;
  double radius_m = 0.0;  ///< Of the wall there: 0 at a corner, infinite along an edge.
};

/// Edges of a world's polygons and its discs on a grid; each cell lists what lies within `range_m`
/// of any point of it. The bounds themselves are no wall. Immutable; safe for concurrent use.
class WallIndex {
 public:
  WallIndex(const World& world, double range_m);

  /// Distance from `origin` along the unit vector `u` to the first wall, at most `reach`.
  /// \pre the whole ray lies within range_m of `standpoint`.
  [[nodiscard]] double cast(Point standpoint, Point origin, Point u, double reach) const noexcept;

  /// `centre` moved out of the walls that a disc of `radius` round it cuts, one wall after the
  /// other, a few rounds; and whether it is then free to within 1 mm. \pre radius <= range_m.
  [[nodiscard]] std::pair<Point, bool> pushed_out(Point centre, double radius) const noexcept;

  /// Distance from `p`, which is free, to the nearest wall; what is further than range_m may be
  /// overlooked.
  [[nodiscard]] double distance_from(Point p) const noexcept;

  /// The walls nearer than `distance_m` to `p`, which is free: edges, then discs, each in the order
  /// of the world. As many as there is room for are written to `walls`; returns how many there are.
  /// \pre distance_m <= range_m.
  [[nodiscard]] std::size_t walls_within(Point p,
                                         double distance_m,
                                         std::span<NearWall> walls) const noexcept;

 private:
  struct Cell {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t first_disc = 0;
    std::uint32_t last_disc = 0;
  };
  [[nodiscard]] Cell cell_at(Point p) const noexcept;

  Bounds bounds_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<Cell> cells_;
  std::vector<Segment> near_;  // cell by cell
  std::vector<Disc> near_discs_;
};

}  // namespace tcert
