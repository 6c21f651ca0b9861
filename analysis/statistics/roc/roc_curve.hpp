#pragma once
/// \file
/// The ROC curve: its points, the area under a part of it, thresholds to act on.
/// Checked against pROC: `coords`, `auc(partial.auc =)`.

#include <cstddef>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/roc/placements.hpp>
#include <vector>

namespace tcert::statistics {

/// A point of the curve: what calling "success" beyond a threshold gets right.
struct RocPoint {
  double threshold = 0.0;    ///< Midway between two neighbouring scores; infinite at both ends.
  double sensitivity = 0.0;  ///< Share of successes called success.
  double specificity = 0.0;  ///< Share of failures called failure.
};

struct RocCurve {
  std::size_t successes = 0;
  std::size_t failures = 0;
  std::vector<RocPoint> points;  ///< From "everything is called success" to "nothing is".
};

/// The curve, as `pROC::coords` lists it. Rows with a NaN are left out; no points unless both
/// classes are there. `success` holds 0, 1 or NaN. \throws std::invalid_argument if the lengths
/// differ or an outcome is another number. O(n log n).
[[nodiscard]] RocCurve roc_curve(std::span<const double> score,
                                 std::span<const double> success,
                                 HigherMeans higher);

/// Which axis a partial area is bounded on.
enum class RocFocus { specificity, sensitivity };

struct PartialAuc {
  std::optional<double> area;  ///< Between the bounds; at most high - low.
  /// McClish's (1989): 0.5 as little as chance, 1 perfect. NA below the diagonal, where it has no
  /// meaning.
  std::optional<double> corrected;
  Conditions conditions;  ///< one_class, below_diagonal.
};

/// Area under the curve where the focus lies in [low, high], linear between points.
/// \throws std::invalid_argument unless 0 <= low < high <= 1. O(points).
[[nodiscard]] PartialAuc partial_auc(const RocCurve& curve,
                                     double low,
                                     double high,
                                     RocFocus focus = RocFocus::specificity);

/// A threshold with all its rates. NA where nothing is called so.
struct RocThreshold {
  RocPoint point;
  double accuracy = 0.0;
  std::optional<double> ppv;  ///< Share of those called success that are.
  std::optional<double> npv;  ///< Share of those called failure that are.
};

enum class BestBy {
  youden,           ///< Largest sensitivity + specificity.
  closest_topleft,  ///< Least (1 - sensitivity)^2 + (1 - specificity)^2.
};

/// Every threshold that is best, rising with specificity; more than one if they tie, which is
/// decided on whole numbers. Chosen on these rows it is too good on them. O(points).
[[nodiscard]] std::vector<RocThreshold> best_thresholds(const RocCurve& curve, BestBy criterion);

/// Sensitivity where the specificity is `specificity`: the largest at a point that has it, else
/// linear between its neighbours. Empty without a curve.
/// \throws std::invalid_argument unless 0 <= specificity <= 1. O(points).
[[nodiscard]] std::optional<double> sensitivity_at(const RocCurve& curve, double specificity);

}  // namespace tcert::statistics
