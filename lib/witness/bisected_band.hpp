#pragma once
/// \file
/// The largest margin that a band can be stretched to, by bisection.

#include <vector>
#include <witness/band.hpp>

namespace tcert::witness {

/// Margins in m to try.
struct Targets {
  double likely_m = 0.0;  ///< The first.
  double most_m = 0.0;    ///< There is none above it.
};

/// Stretches towards `likely_m` first, then bisects up to `most_m`, to 0.6 mm, within so many
/// `iterations`, of which those taken are subtracted. \pre the band's margin is its estimate.
[[nodiscard]] Band bisected(Band band,
                            const Targets& targets,
                            const BandProblem& problem,
                            int& iterations);

/// Steps out the corners of a route: 20 times every point goes halfway to the middle between its
/// neighbours, but for the ends and, of `held` points at either end, those. \pre two points.
[[nodiscard]] std::vector<Point> smoothed(std::vector<Point> polygon, std::size_t held = 0);

}  // namespace tcert::witness
