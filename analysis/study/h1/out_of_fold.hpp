#pragma once
/// \file
/// AUC and C of H1's rows on clusters that no fit has seen.

#include "analysis/study/h1/model_scores.hpp"
#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Fills `auc_within_folds` and `c_within_folds` of every row and the folds of the panel. A single
/// predictor needs no fit: its raw values are scored within the same folds.
void add_out_of_fold(const H1Data& data,
                     const H1Models& models,
                     const H1Options& options,
                     H1Panel& panel);

}  // namespace tcert::study
