#pragma once
/// \file
/// Kaplan-Meier curves by group, with the cumulative hazard. Checked against `survival::survfit`.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/survival/survival_interval.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// R's stype: the product-limit estimate, or exp(-cumulative hazard).
enum class SurvivalEstimate : std::uint8_t { kaplan_meier, exponential };

/// R's ctype: the sum of d / n, or with tied events taken one after another.
enum class HazardEstimate : std::uint8_t { nelson_aalen, fleming_harrington };

struct CurveOptions {
  std::span<const double> weights;        ///< Case weights >= 0, finite; empty for 1 each.
  const table::Factor* groups = nullptr;  ///< A curve each; null for a single one.
  const table::Factor* cluster =
      nullptr;  ///< Makes the standard errors robust, clusters independent.
  SurvivalEstimate survival = SurvivalEstimate::kaplan_meier;
  HazardEstimate hazard = HazardEstimate::nelson_aalen;
};

/// At a time of the data, events at it included.
struct SurvivalPoint {
  double time = 0.0;
  double at_risk = 0.0;   ///< Weight at risk just before the time.
  double events = 0.0;    ///< Weight of the events at it.
  double censored = 0.0;  ///< Weight of the rows censored at it.
  double survival = 1.0;
  double log_std_error = 0.0;  ///< Of log survival; Greenwood's is infinite where survival is 0.
  double cumulative_hazard = 0.0;
  double hazard_std_error = 0.0;

  [[nodiscard]] double std_error() const noexcept;  ///< Of survival; NaN for Greenwood's at 0.
};

struct SurvivalCurve {
  std::string group;  ///< Level of the group; empty if there are none.
  std::size_t rows = 0;
  std::vector<SurvivalPoint> points;  ///< One per distinct stop, ascending.
  Conditions conditions;

  /// The time of the point that `time` is but for rounding (`step_time`), else `time`.
  [[nodiscard]] double time_near(double time) const noexcept;

  /// The curve just after `time`: the last point that is not later, or null before the first. A
  /// point at the same time but for rounding is not later.
  [[nodiscard]] const SurvivalPoint* at(double time) const noexcept;
};

/// A curve per level of the groups, in order; a level without rows has a curve without points.
/// `outcome` has rounded times (`round_times`). Standard errors are Greenwood's, that of the hazard
/// its Poisson form; with a cluster or fractional weights both are robust: the infinitesimal
/// jackknife of rows or clusters (R does so too); NaN in a group of one cluster. Conditions:
/// no_rows (an error), no_events, one_cluster (warnings), few_clusters (a note). O(n log n).
/// \throws std::invalid_argument if lengths differ, a factor has missing codes, or a weight, time
/// or event is out of range.
[[nodiscard]] std::vector<SurvivalCurve> survival_curves(const SurvivalOutcome& outcome,
                                                         const CurveOptions& options = {});

/// Time by which a share `p` of the group has had its event: the least time where survival is at
/// most 1 - p; midway to the next drop where it equals it, as R's `quantile` has it.
struct SurvivalQuantile {
  double p = 0.5;
  std::optional<double> time;
  std::optional<double> low;   ///< Where the lower limit of the curve crosses.
  std::optional<double> high;  ///< Where the upper limit does; empty if it never does.
};

/// O(points). \throws std::invalid_argument if `p` is not in (0, 1) or `level` neither.
[[nodiscard]] SurvivalQuantile survival_quantile(const SurvivalCurve& curve,
                                                 double p,
                                                 IntervalScale scale = IntervalScale::log,
                                                 double level = 0.95);

/// Mean time to the event within [0, limit], the area under the curve.
struct RestrictedMean {
  double limit = 0.0;
  double mean = 0.0;
  double std_error = 0.0;  ///< Greenwood's form, also for robust curves, as R has it.
};

/// O(points).
[[nodiscard]] RestrictedMean restricted_mean(const SurvivalCurve& curve, double asked);

/// The latest time of any of the curves: R's `rmean = "common"`; 0 without points.
[[nodiscard]] double common_limit(std::span<const SurvivalCurve> curves) noexcept;

/// Rows at risk just before each of `times`, per group (one if `groups` is null): those that
/// started before the time and stop at or after it. [group][time]. O(n log m). \throws
/// std::invalid_argument if lengths differ or a group is missing.
[[nodiscard]] std::vector<std::vector<std::size_t>> numbers_at_risk(const SurvivalOutcome& outcome,
                                                                    const table::Factor* groups,
                                                                    std::span<const double> asked);

}  // namespace tcert::statistics
