#pragma once
/// \file
/// The first H1 table and what goes with it: issuance and the spread of the early certificate.

#include "analysis/hypotheses_h1.hpp"
#include "reports/table.hpp"

namespace tcert {

/// AUC of every predictor with its DeLong interval, and the certificate's gain over each rival;
/// one row per predictor and panel.
[[nodiscard]] Table h1_table(const H1Table& h1);

/// Certificates issued, by outcome.
[[nodiscard]] Table issuance_table(const H1Table& h1);

/// Deciles of TC_early, the share that is missing and the share below 0; by panel and outcome.
[[nodiscard]] Table tc_early_table(const H1Table& h1);

}  // namespace tcert
