#pragma once
/// \file
/// The per-trial tables of cells: from the cache where they are there, else made.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/study/experiment/cell.hpp"
#include "analysis/study/experiment/study_cells.hpp"
#include "cli/runs/experiment/cache.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/progress.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

/// Tables of the cells, each distinct one once: cells whose parameters agree in all that a table
/// depends on share it.
struct CellFiles {
  std::vector<std::size_t> features_of;  ///< Per cell: index into `features`; kNoTable if refused.
  std::vector<std::size_t> replays_of;   ///< Likewise into `replays`.
  std::vector<std::string> features;     ///< CSV with header, as `certify` writes features.csv.
  std::vector<std::string> replays;      ///< As `replay` writes replay.csv for the cell's law.
  std::vector<std::string> rejected;     ///< Trials that cannot be read.
  std::vector<ManifestFile> inputs;
  std::size_t from_cache = 0;  ///< Tables x chunks of trials.
  std::size_t made = 0;
  study::CellReuse reuse;  ///< Of the steps within what was made.
};

/// Which tables cells have, none of them made.
[[nodiscard]] CellFiles unmade_files(std::span<const study::PlannedCell> cells);

/// Trials are taken in chunks, and a chunk's results are stored when it is done, so that a run
/// that was stopped goes on where it was. `store` may be null. \throws BadData under --strict.
[[nodiscard]] CellFiles files_of_cells(const OpenedBundle& opened,
                                       std::int64_t threads,
                                       Progress& progress,
                                       std::span<const study::PlannedCell> cells,
                                       Cache* store);

}  // namespace tcert::cli
