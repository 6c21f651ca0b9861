#pragma once
/// \file
/// An exploration as tables: one row a step, and its way.

#include <optional>
#include <string>
#include <terrain/explore.hpp>

#include "reports/column_doc.hpp"
#include "reports/table.hpp"

namespace tcert {

/// The columns of the series, in order.
[[nodiscard]] std::vector<ColumnDoc> explore_columns();

/// One row a step. The certificate is missing until start and goal are joined.
[[nodiscard]] Table explore_table(const terrain::ExploreResult& result,
                                  const std::optional<SyntheticLabel>& synthetic);

/// The positions the robot went through, in order: x, y.
[[nodiscard]] Table path_table(const terrain::ExploreResult& result,
                               const std::optional<SyntheticLabel>& synthetic);

}  // namespace tcert
