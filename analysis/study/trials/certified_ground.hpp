#pragma once
/// \file
/// The link of the two systems: a corridor that was felt, over ground that is certified.

#include <terrain/body.hpp>

#include "datasets/terrain_file.hpp"
#include "datasets/ticks.hpp"

namespace tcert::study {

/// A safe set S_t on the map of a bundle's course. Certificates of the ticks that it leaves are
/// those of the intersection of the tactile corridor with it: Remark 1 of the paper, with a slack
/// of the ground that is unbounded on S_t and -infinity elsewhere.
class CertifiedGround {
 public:
  /// `safe`: cells that hold 1 are certified, as in rasters/safe of an exploration; its frame is
  /// the course's, in metres. \throws std::invalid_argument for a frame that is not declared or not
  /// square, and for a body that is none.
  CertifiedGround(const TerrainGrid& safe, double body_width_m);

  /// True if a disc of the body's width at `p`, and all the way from there to `q` in a straight
  /// line, lies on certified ground. O(length in cells).
  [[nodiscard]] bool holds(const Point& p, const Point& q) const;

  /// The ticks at which the body lies on it, in order. Where some are left out, or the straight
  /// line from one to the next leaves it, the path is broken: nothing is credited across.
  [[nodiscard]] TickTable ticks_on(const TickTable& ticks) const;

 private:
  [[nodiscard]] terrain::Position cells_of(const Point& p) const;

  MapFrame frame_;
  terrain::Grid grid_;
  terrain::CellSet standing_;
};

}  // namespace tcert::study
