#pragma once
/// \file
/// The verdicts of H1 to H3 with the numbers behind them and the rule they were made by.

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"
#include "analysis/study/h3/hypothesis_h3.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Of success and of time in each panel, over all pairs of trials and within strata.
[[nodiscard]] Table h1_findings(const study::H1Table& h1);

/// Of AUC and of C in each panel.
[[nodiscard]] Table h2_findings(const study::H2Table& h2);

/// Of each law and beta over all lightings together.
[[nodiscard]] Table h3_findings(const study::H3Table& h3);

}  // namespace tcert
