#pragma once
/// \file
/// What the figures of H1 draw: the ROC curve of every row, and how well models are calibrated.

#include "analysis/study/h1/model_scores.hpp"
#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Fills `roc` and `calibration` of the panel. A single predictor's curve is that of its raw values
/// in its a-priori direction, a model's that of its fixed part on the trials of the fit: the curves
/// whose areas are the rows' AUCs. Calibration is out of fold, with the folds of the other numbers:
/// the predictor under test alone, the rivals together, the predictor added.
void add_curves(const H1Data& data,
                const H1Models& models,
                const H1Options& options,
                H1Panel& panel);

}  // namespace tcert::study
