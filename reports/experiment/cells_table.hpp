#pragma once
/// \file
/// The tables of cells: H1 by cell and panel, how each cell issues certificates, and what its
/// speed law gains.

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/study/experiment/cell.hpp"
#include "analysis/study/experiment/cell_scores.hpp"
#include "analysis/study/h3/hypothesis_h3.hpp"
#include "reports/table.hpp"

namespace tcert {

/// What the footnotes say of how they were made.
struct CellNotes {
  double level = 0.95;
  std::size_t replicates = 0;
  std::string cluster;
  statistics::BootstrapMethod interval = statistics::BootstrapMethod::expanded;
};

/// Columns, no rows. Each begins with the cell's name, parameters and status.
[[nodiscard]] Table cells_table(const CellNotes& notes);
[[nodiscard]] Table cell_issuance_table();
[[nodiscard]] Table cell_speed_table(const CellNotes& notes);

/// What a cell has in these tables behind its name: one row per panel; one row; one row of the
/// first case of all lightings together, or an empty one.
[[nodiscard]] std::vector<std::vector<TableCell>> cell_panels(const study::CellScores& scores);
[[nodiscard]] std::vector<TableCell> cell_issuance(const study::CellIssuance& count);
[[nodiscard]] std::vector<TableCell> cell_speed(const study::H3Table& h3);

/// Appends a cell with its rows, or with one row of missing cells if there are none. `status` is
/// "done" or why there is nothing.
void add_cell(const study::Cell& cell,
              const std::string& status,
              const std::vector<std::vector<TableCell>>& rows,
              Table& table);

}  // namespace tcert
