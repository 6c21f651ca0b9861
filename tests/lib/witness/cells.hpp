#pragma once
/// \file
/// Free spaces by a rule, and robots by two numbers, for the tests of the witness.

#include <cstddef>
#include <tcert/robot.hpp>
#include <witness/free_cells.hpp>

namespace tcert::witness {

inline constexpr double kCell = 0.005;

/// Free are the cells whose middles are.
template <class IsFree>
FreeCells cells_where(Point low, Point high, IsFree is_free) {
  FreeCells cells(low, high, kCell, std::size_t{1} << 24U);
  const Lattice& lattice = cells.lattice();
  for (int iy = 1; iy + 1 < lattice.rows; ++iy) {
    for (int ix = 1; ix + 1 < lattice.columns; ++ix) {
      if (is_free(lattice.corner(ix, iy) + Point{0.5 * kCell, 0.5 * kCell})) {
        cells.mark(ix, iy);
      }
    }
  }
  return cells;
}

inline Robot robot_of(double width_m, double radius_m) {
  Robot robot;
  robot.body_width_m = width_m;
  robot.min_turn_radius_m = radius_m;
  return robot;
}

}  // namespace tcert::witness
