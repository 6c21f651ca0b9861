#pragma once
/// \file
/// The difficulty metrics of the BARN worlds.

#include <map>
#include <string>
#include <vector>

#include "datasets/import/barn_table.hpp"

namespace tcert {

/// m1 to m5, and those of norm1 to norm5 that the table has.
[[nodiscard]] std::vector<std::string> metric_columns(const BarnSource& metrics);

/// World -> its metrics as cells, each with a comma before it. Worlds with a bad cell are left out
/// with an error. \pre the columns and `world` are there.
[[nodiscard]] std::map<long, std::string> metrics_by_world(const BarnSource& metrics,
                                                           const std::vector<std::string>& columns);

}  // namespace tcert
