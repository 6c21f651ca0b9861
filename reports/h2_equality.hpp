#pragma once
/// \file
/// The tables of H2 that compare groups.

#include "analysis/study/h2/hypothesis_h2.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Are the groups equivalent, are they different: one row for AUC and one for C.
[[nodiscard]] Table h2_equality_table(const study::H2Table& h2);

/// Differences of all pairs.
[[nodiscard]] Table h2_pair_table(const study::H2Table& h2);

/// Does the effect of the predictor differ between groups?
[[nodiscard]] Table h2_interaction_table(const study::H2Table& h2);

/// Every entry of the joint covariances of the groups' AUCs and Cs, one a row.
[[nodiscard]] Table h2_covariance_table(const study::H2Table& h2);

}  // namespace tcert
