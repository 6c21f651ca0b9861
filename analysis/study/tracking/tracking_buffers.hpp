#pragma once
/// \file
/// The tracking buffers of a robot, measured on runs (paper 2.2).

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "datasets/tracking_runs.hpp"

namespace tcert::study {

struct TrackingOptions {
  double lag_s = 2.0;        ///< How far in time the nominal path is looked at round a sample.
  double window_m = 0.25;    ///< Of travel, over which a curvature is told that is not stated.
  double deadband_m = 0.01;  ///< Shorter steps are no travel.
};

/// The largest errors of one run.
struct RunErrors {
  std::string run;
  std::string day;
  std::size_t samples = 0;
  double travel_m = 0.0;
  double path_m = 0.0;       ///< From the executed position to the nominal path.
  double path_time_s = 0.0;  ///< When.
  double same_time_m = 0.0;  ///< To the nominal position of the same time: the paper's formula.
  std::optional<double> curvature_per_m;  ///< |executed - nominal|; empty if neither could be told.
  std::optional<double> curvature_time_s;  ///< When.
  std::optional<double> excess_per_m;      ///< |executed| - |nominal|, at least 0.
};

struct TrackingBuffers {
  std::vector<RunErrors> runs;
  std::size_t days = 0;  ///< 0 if they are not told.
  double path_m = 0.0;   ///< The largest of all runs, as are the next.
  double same_time_m = 0.0;
  std::optional<double> curvature_per_m;
  std::size_t without_curvature = 0;  ///< Runs too short to tell one.
};

/// The distance is that to the nominal path as a polyline, of which only the stretch within lag_s
/// of the sample's time counts: a path that comes by again later hides no error. It is at least the
/// distance to the whole polyline and, with lag_s = 0, the one at the same time. A curvature is the
/// turn of the heading over the last window_m of travel: of the executed path the yaw, of the
/// nominal one the direction of its steps. O(samples times those within lag_s). \pre no run is
/// empty.
[[nodiscard]] TrackingBuffers tracking_buffers(const TrackingRuns& runs,
                                               const TrackingOptions& options);

/// 1 - share^n: how sure it is that the largest of n independent draws, of any distribution, is at
/// least its `share` quantile (Wilks, Ann. Math. Statist. 12:91, 1941). \pre 0 < share < 1.
[[nodiscard]] double wilks_confidence(std::size_t n, double share);

/// The share for which that is `confidence`. \pre n > 0, 0 < confidence < 1.
[[nodiscard]] double wilks_share(std::size_t n, double confidence);

}  // namespace tcert::study
