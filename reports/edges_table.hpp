#pragma once
/// \file
/// The corridor graph of a trial as CSV, one row an edge: what a map of the trial is drawn from.

#include <optional>
#include <string>
#include <vector>
#include <witness/edge_paths.hpp>

#include "analysis/study/trials/certify_trial.hpp"
#include "reports/column_doc.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Header and rows, in the order in which the edges were found. With `proofs`, which may be null, a
/// column more: what each proves.
[[nodiscard]] std::string edges_csv(const study::TrialSeries& series,
                                    const witness::EdgePaths* proofs,
                                    const std::optional<SyntheticLabel>& synthetic);

/// What its columns mean, in their order.
[[nodiscard]] std::vector<ColumnDoc> edge_column_docs();

}  // namespace tcert
