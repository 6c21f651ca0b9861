#pragma once
/// \file
/// The tables of H1 and what goes with them: issuance and the spread of the early certificate.

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "reports/fit/fit_report.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Success: AUC of every row with its interval, gain of the certificate, out of fold.
[[nodiscard]] Table h1_success_table(const study::H1Table& h1);

/// Time: C likewise, and hazard ratios of egress.
[[nodiscard]] Table h1_time_table(const study::H1Table& h1);

/// "early certificate margin against contact heuristics"; other predictors by their columns.
[[nodiscard]] std::string h1_subject(const study::H1Table& h1);

/// Success again, by the paper's model: odds ratios and variances of a logistic mixed model.
[[nodiscard]] Table h1_mixed_table(const study::H1Table& h1);

/// Time again, of those that arrive: R2 and ratios of a linear mixed model of its logarithm.
[[nodiscard]] Table h1_log_time_table(const study::H1Table& h1);

/// Points of the ROC curve of every row.
[[nodiscard]] Table h1_roc_table(const study::H1Table& h1);

/// Bins of out-of-fold probabilities, and their slope and intercept.
[[nodiscard]] Table h1_calibration_table(const study::H1Table& h1);
[[nodiscard]] Table h1_recalibration_table(const study::H1Table& h1);

/// All of H1 as a document: the tables above, with those within strata; as details issuance, the
/// spread of the predictor, the case-level figures, incidence by quartile, ROC curves, calibration,
/// all intervals, closed-form standard errors and folds.
[[nodiscard]] FitReport h1_report(const study::H1Table& h1);

/// Certificates issued, by outcome.
[[nodiscard]] Table issuance_table(const study::H1Table& h1);

/// Deciles of the predictor under test, the share that is missing and the share below 0; by panel
/// and outcome.
[[nodiscard]] Table tc_early_table(const study::H1Table& h1);

}  // namespace tcert
