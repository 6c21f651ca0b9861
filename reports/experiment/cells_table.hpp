#pragma once
/// \file
/// The tables of a batch: one row a cell and panel, and how each cell issues certificates.

#include <string>
#include <vector>

#include "analysis/experiment/cell.hpp"
#include "analysis/experiment/cell_scores.hpp"
#include "reports/table.hpp"

namespace tcert {

/// What a cell has in the tables behind its name: depends on its features only, so that cells that
/// share them share it.
struct CellRows {
  std::vector<std::vector<TableCell>> scores;  ///< One per panel.
  std::vector<TableCell> issuance;
};

[[nodiscard]] CellRows cell_rows(const CellScores& scores);

/// As text that reads back to the same cells. \throws std::invalid_argument for any other text.
[[nodiscard]] std::string to_text(const CellRows& rows);
[[nodiscard]] CellRows cell_rows_from(const std::string& text);

/// What the footnotes say of how a batch was made.
struct BatchNotes {
  double level = 0.95;
  std::size_t replicates = 0;
  std::string cluster;
};

/// Columns of the tables, no rows.
[[nodiscard]] Table cells_table(const BatchNotes& notes);
[[nodiscard]] Table cell_issuance_table();

/// Appends a cell to the tables. `status` is "done" or why there is nothing.
void add_cell(const Cell& cell,
              const std::string& status,
              const CellRows& rows,
              Table& cells,
              Table& issuance);

}  // namespace tcert
