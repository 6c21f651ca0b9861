#pragma once
/// \file
/// The ground under a body: what must be certified for a robot to stand, and the worst of it.

#include <span>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// Outline of the robot round its reference point, which is where it measures. Lengths in cells.
struct Body {
  enum class Kind {
    point,  ///< What was certified before there were bodies: the cell under the reference point.
    disc,
    box,  ///< A rectangle whose yaw the robot keeps as it moves.
  };
  Kind kind = Kind::point;
  double radius = 0.0;  ///< Of a disc, > 0.
  double length = 0.0;  ///< Of a box, along its yaw, > 0.
  double width = 0.0;   ///< Across it, > 0.
  double yaw = 0.0;     ///< rad, from +x (down the rows) towards +y (along the columns).
};

/// Cells that a body may touch while its reference point lies anywhere in the cell at (0, 0).
class Footprint {
 public:
  /// \throws std::invalid_argument for lengths that are not within their Limit, or not above 0.
  explicit Footprint(const Body& body);

  /// Cells (dx, first) to (dx, last), by dx.
  struct Row {
    int dx = 0;
    int first = 0;
    int last = 0;
  };
  [[nodiscard]] const std::vector<Row>& rows() const noexcept { return rows_; }
  [[nodiscard]] bool is_point() const noexcept { return rows_.size() == 1; }

 private:
  std::vector<Row> rows_;
};

/// Cells at which the whole footprint lies on `ground`; what lies beyond the grid is no ground. A
/// way whose points all round to such cells keeps the body on ground. O(cells + border x rows).
[[nodiscard]] CellSet standing_cells(const Grid& grid,
                                     const CellSet& ground,
                                     const Footprint& footprint);

/// The least of `values` under the footprint at every cell of `standing`; that of the cell itself
/// elsewhere. O(members x footprint). \pre `standing` is of standing_cells()
[[nodiscard]] std::vector<double> least_under(const Grid& grid,
                                              std::span<const double> values,
                                              const CellSet& standing,
                                              const Footprint& footprint);

}  // namespace tcert::terrain
