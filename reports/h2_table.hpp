#pragma once
/// \file
/// The tables of H2: every group, their pairs, the tests of equality and of interaction.

#include "analysis/study/h2/hypothesis_h2.hpp"
#include "reports/fit/fit_report.hpp"
#include "reports/table.hpp"

namespace tcert {

/// AUC, C, odds and hazard ratios of each group.
[[nodiscard]] Table h2_level_table(const study::H2Table& h2);

/// Are the groups equivalent, are they different: one row for AUC and one for C.
[[nodiscard]] Table h2_equality_table(const study::H2Table& h2);

/// All of H2 as a document: the two tables above, all pairs, interactions, closed forms and
/// covariances.
[[nodiscard]] FitReport h2_report(const study::H2Table& h2);

}  // namespace tcert
