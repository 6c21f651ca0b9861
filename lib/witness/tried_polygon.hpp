#pragma once
/// \file
/// A polygon stretched coarse to fine, and what the checker measures of it.

#include <vector>
#include <witness/bisected_band.hpp>
#include <witness/checker.hpp>
#include <witness/found.hpp>

namespace tcert::witness {

struct StretchOptions {
  Targets targets;
  int levels = 1;      ///< At each but the first there are twice as many points.
  int iterations = 0;  ///< Steps of the band, at most, of all levels together.
};

/// Puts into `found` the best of the bands of all levels, as the checker measures them, if that is
/// better than what is there, and else why it is none. \pre at least two points.
void try_polygon(const std::vector<Point>& polygon,
                 const StretchOptions& options,
                 const BandProblem& problem,
                 const Checker& checker,
                 Found& found);

}  // namespace tcert::witness
