#pragma once
/// \file
/// How good predicted risks are at a time: AUC(t), Brier(t) and agreement, weighted for censoring.
/// Checked against `riskRegression::Score` with a marginal Kaplan-Meier curve of censoring.

#include <cstddef>
#include <optional>
#include <span>
#include <statistics/basics/student_t.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// A number with what clusters (or rows) say of it; NaN where there is none.
struct TimeScore {
  double value = 0.0;
  ClusterT spread;
};

struct TimeScores {
  double time = 0.0;
  std::size_t cases = 0;     ///< Events by the time.
  std::size_t controls = 0;  ///< Known to be later.
  TimeScore auc;             ///< Pr(the risk of a case is above that of a control), ties one half.
  TimeScore brier;           ///< Mean squared distance of the risk from what came.
  double brier_null = 0.0;   ///< Of the same risk for all, 1 - Kaplan-Meier.
};

/// `risk` is of an event by `time`, one a row. Rows are weighted by 1 / G of when they were last
/// known, G of all rows (Graf et al. 1999; Blanche et al. 2013). Spreads leave out whole clusters
/// in turn, risks held, t with clusters - 1 degrees of freedom; `cluster` may be null or of
/// too many levels (too_much_to_leave_out), and there is none then. Rows without a finite risk are
/// left out. NaN where no row is known to be later than `time` and the last are censored (G = 0).
/// Intervals lie within [0, 1]. \throws std::invalid_argument if lengths differ or rows enter late.
/// O(clusters n log n).
[[nodiscard]] TimeScores time_scores(const SurvivalOutcome& outcome,
                                     std::span<const double> risk,
                                     double time,
                                     const table::Factor* cluster,
                                     double level);

/// Rows of like risk, and how many of them had their event by the time.
struct RiskBin {
  std::size_t rows = 0;
  double predicted = 0.0;  ///< Mean risk.
  double observed = 0.0;   ///< 1 - Kaplan-Meier.
  std::optional<Interval>
      interval;  ///< Of it, on the log-log scale; robust where there are clusters.
};

/// Of about as many rows each, by rising risk; rows of one risk stay together. \throws
/// std::invalid_argument as `time_scores`, or without bins.
[[nodiscard]] std::vector<RiskBin> risk_bins(const SurvivalOutcome& outcome,
                                             std::span<const double> risk,
                                             double time,
                                             std::size_t bins,
                                             const table::Factor* cluster,
                                             double level);

}  // namespace tcert::statistics
