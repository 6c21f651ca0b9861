#pragma once
/// \file
/// Area under the ROC curve with DeLong's variance, the paired test of two areas, and the curve.
/// Checked against pROC: `auc`, `var`, `ci.auc`, `roc.test(paired = TRUE)`, all by "delong", with
/// the direction given and never taken from the data.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/interval.hpp"
#include "analysis/placements.hpp"

namespace tcert {

/// Why a number below is missing, or says less than it seems to.
enum class AucCondition {
  no_rows,        ///< No complete row.
  no_successes,   ///< One class only: no AUC.
  no_failures,    ///< One class only: no AUC.
  one_success,    ///< A class of a single row: an AUC, but no variance.
  one_failure,    ///< The same.
  all_tied,       ///< The predictor is constant: AUC 0.5 with variance 0 says nothing.
  separated,      ///< AUC is 0 or 1: its variance 0 is misleading.
  same_ranking,   ///< Paired: both predictors rank every pair alike; difference 0 with variance 0.
  zero_variance,  ///< Paired: the difference is not 0, but its variance is; no test.
};

/// The enumerator's words, for instance "all tied".
[[nodiscard]] std::string_view to_string(AucCondition condition) noexcept;

struct AucEstimate {
  std::size_t successes = 0;  ///< Among the complete rows.
  std::size_t failures = 0;
  std::size_t missing = 0;  ///< Rows left out: score or outcome is NaN.
  std::optional<double> auc;
  std::optional<double> variance;    ///< DeLong's.
  std::optional<Interval> interval;  ///< Wald on the AUC, clipped to [0, 1].
  std::vector<AucCondition> conditions;
};

/// Pr(a success outranks a failure), ties counting one half.
/// `score` may hold infinities; NaN is missing. `success` holds 0, 1 or NaN.
/// \throws std::invalid_argument if the lengths differ, an outcome is another number, or `level` is
/// not in (0, 1). O(n log n).
[[nodiscard]] AucEstimate auc(std::span<const double> score,
                              std::span<const double> success,
                              HigherMeans higher,
                              double level = 0.95);

/// A predictor with its a-priori direction.
struct Score {
  std::span<const double> values;
  HigherMeans higher = HigherMeans::success;
};

struct AucDifference {
  std::size_t successes = 0;
  std::size_t failures = 0;
  std::size_t missing = 0;  ///< Rows where either score or the outcome is NaN.
  std::optional<double> first_auc;
  std::optional<double> second_auc;
  std::optional<double> difference;  ///< First minus second.
  std::optional<double> variance;
  std::optional<Interval> interval;
  std::optional<double> z;
  std::optional<double> p_value;  ///< Two-sided, normal.
  std::vector<AucCondition> conditions;
};

/// DeLong's test of two AUCs on the same rows: those complete in both. The rows are taken as
/// independent. \throws std::invalid_argument as `auc` does. O(n log n).
[[nodiscard]] AucDifference paired_auc_test(const Score& first,
                                            const Score& second,
                                            std::span<const double> success,
                                            double level = 0.95);

/// A point of the curve: what calling "success" beyond a threshold gets right.
struct RocPoint {
  double threshold = 0.0;    ///< Midway between two neighbouring scores; infinite at both ends.
  double sensitivity = 0.0;  ///< Share of successes called success.
  double specificity = 0.0;  ///< Share of failures called failure.
};

/// From "everything is called success" to "nothing is", as `pROC::coords` lists them. Missing rows
/// are left out; empty unless both classes are there. \throws std::invalid_argument as `auc` does.
[[nodiscard]] std::vector<RocPoint> roc_points(std::span<const double> score,
                                               std::span<const double> success,
                                               HigherMeans higher);

}  // namespace tcert
