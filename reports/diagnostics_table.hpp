#pragma once
/// \file
/// Problems of inputs as a table: diagnostics.csv and what `check` prints.

#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

/// Columns, no rows.
[[nodiscard]] Table diagnostics_table(const std::optional<SyntheticLabel>& synthetic);

/// `trial_id` is empty for a problem of the bundle.
[[nodiscard]] std::vector<TableCell> diagnostics_row(const std::string& trial_id,
                                                     const table::Diagnostic& diagnostic);

}  // namespace tcert
