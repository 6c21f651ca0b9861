#pragma once
/// \file
/// The models of H1 without each unit, where there are too many units to refit them.

#include <statistics/resampling/resampling_plan.hpp>
#include <vector>

#include "analysis/study/h1/model_scores.hpp"

namespace tcert::study {

/// Of a model without each unit: NaN where the model has no finite maximum.
struct ModelLeftOut {
  std::vector<double> score;  ///< Its AUC, or C.
  std::vector<double> added;  ///< The coefficient of its last predictor.
};

/// The logistic model and its AUC, or the Cox model and its C, to first order: coefficients move by
/// one Newton step (`one_step_changes`); the score is the exact one of the other rows by the
/// coefficients of all, plus its slope times that move. The slope is that of the score of all rows
/// over a standard error to either side. O(n log n) for all units together, where refits take that
/// for each. \pre for `cox_left_out` that the panel has times.
[[nodiscard]] ModelLeftOut logistic_left_out(const H1Data& data,
                                             const H1Model& model,
                                             const statistics::ResamplingPlan& plan);
[[nodiscard]] ModelLeftOut cox_left_out(const H1Data& data,
                                        const H1Model& model,
                                        const statistics::ResamplingPlan& plan);

}  // namespace tcert::study
