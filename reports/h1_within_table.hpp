#pragma once
/// \file
/// How much of what H1 and H2 find is between groups of trials, and how much within them.

#include <string>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "reports/table.hpp"

namespace tcert {

/// "algorithm x lighting"; empty if there are no strata.
[[nodiscard]] std::string h1_within_columns(const study::H1Panel& panel);

/// Those of the first panel that has strata: one that cannot be scored has none.
[[nodiscard]] std::string h1_within_columns(const study::H1Table& h1);

/// Which pairs, how many strata, which share of the pairs that the pooled numbers compare. \pre the
/// panel has strata.
[[nodiscard]] std::string h1_within_note(const study::H1Panel& panel, const std::string& name);

/// AUC and its gains, pooled and within strata, of every predictor; the same of C.
/// \pre a panel has strata.
[[nodiscard]] Table h1_within_table(const study::H1Table& h1);
[[nodiscard]] Table h1_time_within_table(const study::H1Table& h1);

/// Closed forms of what is within strata: what another program can check to the last digit.
[[nodiscard]] Table h1_within_closed_form_table(const study::H1Table& h1);

}  // namespace tcert
