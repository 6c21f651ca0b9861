#pragma once
/// \file
/// Probabilities of a logistic model for clusters that its fit has not seen.

#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/resampling/cross_validation.hpp>
#include <vector>

namespace tcert::statistics {

struct OutOfFold {
  std::vector<double> probability;  ///< One a row of the input; NaN where its fold has no fit.
  Conditions conditions;  ///< Per fold without a fit: one_class_fold, fold_without_fit (warnings).
};

/// Fits the rows outside each fold by maximum likelihood and predicts its own. A fold whose
/// training rows have one class, are separated, or do not determine all coefficients (a level that
/// is only in the fold) has no predictions, and is named. \throws std::invalid_argument as
/// `fit_logistic`, or if rows have trials of other than 1 or weights. One fit a fold.
[[nodiscard]] OutOfFold out_of_fold_probabilities(const LogisticInput& input, const Folds& folds);

}  // namespace tcert::statistics
