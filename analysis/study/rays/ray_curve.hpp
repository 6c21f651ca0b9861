#pragma once
/// \file
/// The curve from a ray's bend to clearance, fitted to pairs of both.

#include <cstddef>
#include <span>
#include <statistics/calibration/isotonic.hpp>
#include <tcert/robot.hpp>

namespace tcert::study {

struct RayCurve {
  statistics::Trend trend = statistics::Trend::falling;
  Calibration calibration;  ///< Knots on the isotonic fit; the clearance is monotone.
  std::size_t pairs = 0;
  double residual_m = 0.0;  ///< Root mean square of clearance less isotonic fit.
  double thinning_m = 0.0;  ///< Largest difference of curve and isotonic fit at a fitted bend.
};

/// Isotonic regression in the direction that the data have, thinned to at most `most_knots`: knots
/// are the first and last block (mean bend, value), then one by one the block that is furthest from
/// the line between the knots in units of its standard error, until none is further than two.
/// Outside the knots the curve keeps the value of the nearest one.
/// \pre as many bends as clearances, at least one, all finite; most_knots >= 2. O(n log n).
[[nodiscard]] RayCurve fit_ray_curve(std::span<const double> bend_rad,
                                     std::span<const double> clearance_m,
                                     std::size_t most_knots);

/// max(curve - by_m, 0), exactly: with a knot where it meets 0, and none beyond it.
/// \pre a calibration with at least one knot.
[[nodiscard]] Calibration lowered(const Calibration& curve, double by_m);

}  // namespace tcert::study
