#pragma once
/// \file
/// The tables of H2: every group, their pairs, the tests of equality and of interaction.

#include "analysis/study/h2/hypothesis_h2.hpp"
#include "reports/fit/fit_report.hpp"
#include "reports/table.hpp"

namespace tcert {

/// All of H2 as a document: AUC, C, odds and hazard ratios of each group; whether the groups are
/// equivalent or different, all pairs and interactions; closed forms and covariances.
[[nodiscard]] FitReport h2_report(const study::H2Table& h2);

}  // namespace tcert
