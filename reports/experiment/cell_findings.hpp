#pragma once
/// \file
/// What cells found, in sentences: which cells change the early certificate, and which issue
/// certificates that the full method does not.

#include "reports/table.hpp"

namespace tcert {

/// \pre tables of `cells_table` and `cell_issuance_table`.
[[nodiscard]] Table cell_findings(const Table& cells, const Table& issuance);

}  // namespace tcert
