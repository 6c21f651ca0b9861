#pragma once
/// \file
/// The cells that a request asks for: of a file, of a grid.

#include <string>
#include <vector>

#include "analysis/study/experiment/cell.hpp"
#include "cli/runs/experiment/cells.hpp"

namespace tcert::cli {

/// Cells of a CSV file: a column `cell` with names (rows are numbered without it), every other
/// column a parameter, an empty cell the value of the full method. \throws NoInput, BadData.
[[nodiscard]] std::vector<study::Cell> cells_of_file(const CellsRequest& options,
                                                     Progress& progress);

/// Every combination of "KEY=V1,V2,...". \throws UsageError.
[[nodiscard]] std::vector<study::Cell> cells_of_grid(const std::vector<std::string>& texts);

}  // namespace tcert::cli
