#pragma once
/// \file
/// What known worlds are worth: one row a world.

#include <string>
#include <vector>

#include "analysis/study/truth/truth.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Columns, no rows; the footnotes say what the numbers are.
[[nodiscard]] Table world_table(const Robot& robot, const study::TruthOptions& options);

/// A value of minus infinity is missing in the table; the column `connected` says so.
[[nodiscard]] std::vector<TableCell> world_row(const World& world, const study::Truth& truth);

}  // namespace tcert
