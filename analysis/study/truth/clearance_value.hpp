#pragma once
/// \file
/// The clearance-only value of a world: the radius of the largest disc whose centre gets from S to
/// G.

#include <limits>
#include <optional>
#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/world.hpp"

namespace tcert::study {

/// sup over paths from a point of S to a point of G of the least distance to an obstacle or to the
/// bounds of the world along the path; minus infinity if every path meets one.
struct ClearanceValue {
  static constexpr double kNoPath = -std::numeric_limits<double>::infinity();

  double clearance_m = kNoPath;
  double lower_m = kNoPath;  ///< The true value lies in [lower_m, upper_m].
  double upper_m = kNoPath;
  std::optional<Point> bottleneck;  ///< Where the disc is stopped first, if there is a path.
};

/// \throws std::invalid_argument naming the world unless it has S and G.
void require_regions(const World& world);

/// True if all obstacles, S and G are discs, so that exact_disc_clearance takes the world.
[[nodiscard]] bool is_disc_field(const World& world) noexcept;

/// Exact, up to rounding, for discs of any radii. Discs less than 2 nm apart touch: no path.
///
/// Blow up every obstacle and the walls that the bounds make by c, and call the union, less S and
/// G, B(c). A disc of radius c gets from S to G iff B(c) does not separate them (inside S and G
/// nothing needs to be clear: the path leaves S for the last time and then reaches G, and what lies
/// between is outside of both). By Alexander duality it separates them iff some closed curve in
/// B(c) winds round one of the two centres, modulo 2, more often than round the other. S and G hold
/// no obstacle's centre and do not overlap, so a blown-up disc less S and G is simply connected
/// until it covers S or G; then the nerve (Mayer-Vietoris) says that every closed curve is, as far
/// as the winding goes, a sum of cycles of the graph with an edge for each *component* of each
/// pair's overlap. A component is born at the middle of the pair's gap, c = gap / 2, or, where
/// that lies in S or G, at a point where the set equally far from both obstacles crosses the edge
/// of S or G: for circles that hold no centre of an obstacle no other local minimum of the larger
/// of the two distances exists. A curve inside a blown-up disc can be drawn straight, for straight
/// it leaves the centre of S on the side on which S sticks out. So: sort the births, join the
/// obstacles in that order in a union-find structure that knows the parity of crossings of the
/// segment from S's centre to G's, and stop at the first odd cycle, or when S or G is covered.
///
/// O((n + k) log n), k the pairs closer than about four times the answer, if n discs are spread
/// out: pairs are looked for in a band of x, so O(n^2) of them are compared if all lie above one
/// another. A pair whose gap's middle lies in S or G costs a quartic in addition. \throws
/// std::invalid_argument unless is_disc_field(world).
[[nodiscard]] ClearanceValue exact_disc_clearance(const World& world);

struct GridClearance {
  ClearanceValue value;
  std::vector<Point> path;  ///< Cell centres from S to G, a widest path on the grid; or empty.
};

/// For any world, on square cells of `step_m`: |error| <= sqrt(2) step_m.
///
/// A cell is marked if its centre lies within step / sqrt(2) of an obstacle; that includes all
/// cells that touch one. So the exact distance between the centre of a free cell and the nearest
/// marked centre (Felzenszwalb and Huttenlocher, 2012) is within step / sqrt(2) of the clearance
/// there. Any path runs through cells whose centres are within step / sqrt(2) of it, and between
/// centres of cells that touch no point is further than that from one of them. The two add up. If
/// no path is found, the true value is at most sqrt(2) step_m.
///
/// O(cells log cells) time, 13 bytes a cell.
/// \throws std::invalid_argument if S or G is missing, or if there would be no cell or more than
/// 2^27.
[[nodiscard]] GridClearance grid_clearance(const World& world, double step_m);

}  // namespace tcert::study
