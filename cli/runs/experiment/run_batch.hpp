#pragma once
/// \file
/// Running a batch of cells, whichever they are.

#include "analysis/study/experiment/cell.hpp"
#include "cli/runs/experiment/batch.hpp"
#include "cli/runs/written_options.hpp"

namespace tcert::cli {

/// What is run, and what is written of it.
struct Batch {
  std::string command;
  const BatchRequest& options;
  WrittenOptions written;
  bool is_grid = false;  ///< A value with which no cell is possible is an error, before any runs.
};

/// The full method, then `cells`. \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode run_batch(Batch batch, std::vector<study::Cell> cells, Progress& progress);

}  // namespace tcert::cli
