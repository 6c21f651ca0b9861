#pragma once
/// \file
/// An elastic band: a polygon that is moved until the path it stands for has a wanted margin.

#include <cstddef>
#include <tcert/region.hpp>
#include <tcert/robot.hpp>
#include <vector>
#include <witness/distance_field.hpp>

namespace tcert::witness {

struct BandProblem {
  const DistanceField& field;
  const Region& start;
  const Region& goal;
  const Robot& robot;
  /// So many points at either end stay where they are; two keep the headings at the ends as well.
  std::size_t held = 0;
};

/// A polygon and the margin that estimate() gives it.
struct Band {
  std::vector<Point> polygon;
  double margin_m = 0.0;
};

/// Moves the points of `polygon`, about equally far apart, towards the margin `wanted_m`, in at
/// most `iterations` steps, of which those taken are subtracted. Its first point stays in S, its
/// last in G, if they are not held. Hands back the best that was met, `polygon` itself if nothing
/// was better.
///
/// Least squares by Gauss and Newton, damped (Levenberg and Marquardt): what lacks of the clearance
/// at the middle of each edge, what a corner turns by too much, and, as weak terms, uneven edges
/// and bends. The normal equations have a band of 6, so that a step is O(points).
[[nodiscard]] Band stretched(const std::vector<Point>& polygon,
                             double wanted_m,
                             const BandProblem& problem,
                             int& iterations);

}  // namespace tcert::witness
