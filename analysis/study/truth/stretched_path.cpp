#include "analysis/study/truth/stretched_path.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <witness/search.hpp>

#include "analysis/study/truth/cell_grid.hpp"

namespace tcert::study {
namespace {

constexpr std::size_t kMostPathCells = std::size_t{1} << 24U;
constexpr int kBandSteps = 2000;
constexpr double kSpacing = 0.02;  // m, of the poses that stand for a first path

/// The cells within the bounds that no obstacle touches.
witness::FreeCells cells_of(const World& world, double cell_m) {
  const Point low = world.bounds.low;
  const Point high = world.bounds.high;
  witness::FreeCells cells(low, high, cell_m, kMostPathCells);
  const witness::Lattice& lattice = cells.lattice();
  const CellGrid grid{lattice.corner(0, 0),
                      cell_m,
                      static_cast<std::size_t>(lattice.columns),
                      static_cast<std::size_t>(lattice.rows)};
  std::vector<std::uint8_t> touched(grid.size(), 0);
  const double reach_m = (1.0 + 1e-9) * 0.5 * std::numbers::sqrt2 * cell_m;
  for (const Region& obstacle : world.obstacles) {
    mark_region(grid, obstacle, reach_m, touched);
  }
  const auto is_within = [&](int ix, int iy) {
    const Point from = lattice.corner(ix, iy);
    const Point to = lattice.corner(ix + 1, iy + 1);
    return from.x_m >= low.x_m && from.y_m >= low.y_m && to.x_m <= high.x_m && to.y_m <= high.y_m;
  };
  for (int iy = 0; iy < lattice.rows; ++iy) {
    for (int ix = 0; ix < lattice.columns; ++ix) {
      const auto place = static_cast<std::size_t>(iy) * grid.columns + static_cast<std::size_t>(ix);
      if (touched[place] == 0 && is_within(ix, iy)) {
        cells.mark(ix, iy);
      }
    }
  }
  return cells;
}

witness::Samples poses_along(const std::vector<Arc>& path) {
  witness::Samples samples;
  for (const Arc& arc : path) {
    const auto steps = static_cast<int>(std::ceil(arc.length_m / kSpacing));
    for (int k = 0; k <= steps; ++k) {
      samples.poses.push_back(pose_at(arc, arc.length_m * k / std::max(steps, 1)));
      samples.breaks.push_back(samples.poses.size() == 1 ? 1 : 0);
    }
  }
  return samples;
}

Arc arc_of(const witness::Piece& piece) {
  const double turn = std::abs(piece.turn_rad);
  const double length_m = turn > 0.0 ? witness::radius(piece) * turn : witness::chord(piece);
  return {{piece.from, witness::heading_from(piece)}, piece.turn_rad / length_m, length_m};
}

}  // namespace

std::vector<Arc> stretched_path(const World& world,
                                const Robot& robot,
                                double cell_m,
                                const std::vector<Arc>& first) {
  std::vector<Arc> path;
  try {
    const witness::FreeCells cells = cells_of(world, cell_m);
    const witness::SearchSpace space(cells);
    const witness::Found found =
        witness::search(space, *world.start, *world.goal, robot, poses_along(first), kBandSteps);
    if (found.witness) {
      for (const witness::Piece& piece : found.witness->path) {
        path.push_back(arc_of(piece));
      }
    }
  } catch (const std::length_error&) {
    path.clear();  // too many cells
  }
  return path;
}

}  // namespace tcert::study
