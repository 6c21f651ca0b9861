#pragma once
/// \file
/// The margin that a path proves, whoever found it. Includes nothing of the search.

#include <string>
#include <tcert/robot.hpp>
#include <witness/border_cells.hpp>
#include <witness/free_cells.hpp>
#include <witness/path.hpp>

namespace tcert::witness {

/// What a path W proves of a run. Lengths in metres.
struct Checked {
  std::string refused;         ///< Why W is no path from S to G within F_t; empty if it is one.
  double margin_m = 0.0;       ///< Of a W that is not refused.
  double clearance_m = 0.0;    ///< Distance of W to what is not free: a lower bound, see Checker.
  double turn_radius_m = 0.0;  ///< Smallest radius of W; infinity if it is straight.
  Point bottleneck;            ///< A place of W, within 5 cm, at which the margin is decided.
};

/// Measures paths through one free space.
///
/// margin = min(2 clearance - w_B - 2 eps_trk, 1 / (1 / rho + eps_kappa) - R_min) of the path, the
/// paper's (2.2). The robot's rays do not matter.
///
/// - The distance is that to the nearest cell that is not free, cells closed, exact for straight
///   pieces; arcs are cut into chords, and how far an arc bulges, at most 0.05 mm, is taken off, so
///   that of an arc it is at most 0.1 mm too small.
///   Floating point adds less than 1e-9 m at coordinates below 10^6 m.
/// - Pieces must meet exactly, and their headings within 1e-6 rad; what they differ by is added to
///   the turning of the pieces on both sides. Where R_min is 0 a corner is allowed, of radius 0.
///
/// Refused: no piece; a number that is not finite; a piece of no length or that turns by more than
/// 3 rad; pieces that do not meet; a corner; a begin outside of S or an end outside of G; S and G
/// that overlap; a path that leaves F_t; an F_t with free cells along the border of its lattice.
class Checker {
 public:
  /// Of cells that outlive it. O(cells / 64 + cells of the border).
  explicit Checker(const FreeCells& cells) : cells_(cells), borders_(cells) {}
  explicit Checker(FreeCells&&) = delete;

  /// O(pieces x cells at the border of F_t nearby).
  [[nodiscard]] Checked check(const Path& path,
                              const Region& start,
                              const Region& goal,
                              const Robot& robot) const;

 private:
  const FreeCells& cells_;
  BorderCells borders_;
};

/// Of a single path: see Checker.
[[nodiscard]] Checked check(const Path& path,
                            const FreeCells& cells,
                            const Region& start,
                            const Region& goal,
                            const Robot& robot);

}  // namespace tcert::witness
