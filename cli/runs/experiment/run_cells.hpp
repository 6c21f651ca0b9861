#pragma once
/// \file
/// Running cells, one after the other, whichever they are.

#include "analysis/study/experiment/cell.hpp"
#include "cli/runs/experiment/cells.hpp"
#include "cli/runs/items.hpp"
#include "cli/runs/written_options.hpp"

namespace tcert::cli {

/// What is run, and what is written of it.
struct CellsRun {
  std::string command;
  const CellsRequest& options;
  WrittenOptions written;
  bool is_grid = false;  ///< A value with which no cell is possible is an error, before any runs.
};

/// The full method, then `cells`; what came of them is made here, or had from a source.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode run_cells(CellsRun run,
                                 std::vector<study::Cell> cells,
                                 Progress& progress,
                                 const ItemSource* source = nullptr);

/// What came of each, in pieces. \throws UsageError, NoInput, BadData.
[[nodiscard]] ItemSet items_of_cells(const CellsRun& run,
                                     std::vector<study::Cell> cells,
                                     Progress& progress);

}  // namespace tcert::cli
