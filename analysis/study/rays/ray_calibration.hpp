#pragma once
/// \file
/// The calibration of a robot's rays, with a lower bound that holds on a new day.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tcert/robot.hpp>
#include <vector>

#include "analysis/study/rays/ray_curve.hpp"
#include "datasets/ray_pairs.hpp"

namespace tcert::study {

struct RayCalibrationOptions {
  bool bound = true;  ///< False: the curve alone, fitted to all days.
  double alpha = 0.05;
  std::size_t most_knots = 12;
  std::uint64_t seed = 1;  ///< Of the order in which days are dealt out.
};

/// A day that the curves are not fitted to, and the pair of it at which a curve overstates most.
struct DayScore {
  std::string day;
  std::size_t pairs = 0;
  double score_m = 0.0;  ///< Curve less measured clearance, the largest of all its rays and ticks.
  std::size_t ray = 0;
  double bend_rad = 0.0;
  double clearance_m = 0.0;
};

/// The bound: curve - quantile_m.
struct RayBound {
  std::vector<DayScore> days;  ///< That the bound is from, in order of their scores.
  std::size_t rank = 0;        ///< Of the score that is the quantile, among n days.
  double quantile_m = 0.0;
  double coverage = 0.0;        ///< rank / (n + 1): the chance that all of a new day is covered.
  double coverage_low = 0.0;    ///< Of such days: nineteen of twenty bounds like this cover more.
  std::size_t pairs = 0;        ///< Of its days.
  double pairs_above = 0.0;     ///< Share of them that are measured at the bound or above.
  double median_slack_m = 0.0;  ///< Of measured clearance over the bound.
};

struct RayCalibration {
  std::vector<std::string> rays;
  std::vector<RayCurve> curves;     ///< As many as rays.
  std::vector<std::string> fitted;  ///< The days that they are fitted to.
  std::optional<RayBound> bound;
  std::vector<Calibration> usable;  ///< Of each ray: the bound, at least 0; else the curve.
};

struct RayCalibrationResult {
  std::optional<RayCalibration> calibration;
  std::string problem;  ///< Why there is none, and what else can be done.
};

/// How many of so many days the bound is from: half of them, or as many as alpha needs if that is
/// more; 0 if they are too few, for one day must be left for the curves. It depends on nothing that
/// was measured, so that the days of the bound stay exchangeable with a new one.
[[nodiscard]] std::size_t days_of_bound(std::size_t days, double alpha);

/// Fits a curve a ray, and bounds it by split conformal prediction. The exchangeable unit is the
/// day: its trials share a bias. Days are put in an order drawn from the seed; the last
/// days_of_bound() of them are held back, and the curves are fitted to the others alone. The score
/// of a day held back is the largest overstatement, curve - clearance, of all its rays and ticks;
/// thinning, bias, texture and glitches are all in it. With q the conformal quantile of the scores,
/// curve - q is at most the clearance at *all* ticks and rays of a new day with probability
/// >= 1 - alpha, whatever the curve is, if days are exchangeable.
///
/// Refused: fewer days than alpha needs; a ray that no day of the fit has.
/// \pre there is a pair; all are finite. O(pairs log pairs).
[[nodiscard]] RayCalibrationResult calibrate_rays(const RayPairs& pairs,
                                                  const RayCalibrationOptions& options);

}  // namespace tcert::study
