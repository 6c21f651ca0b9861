#pragma once
/// \file
/// Rows of a table as text that reads back to the same cells: how they are kept between runs.

#include <string>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

using CellRows = std::vector<std::vector<TableCell>>;

[[nodiscard]] std::string to_text(const CellRows& rows);

/// \throws std::invalid_argument for any other text.
[[nodiscard]] CellRows cell_rows_from(const std::string& text);

}  // namespace tcert
