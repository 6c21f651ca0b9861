#pragma once
/// \file
/// What comes of running cells: here, or in pieces, cell by cell, as lines of text.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "cli/runs/experiment/cache.hpp"
#include "cli/runs/experiment/cell_files.hpp"
#include "cli/runs/experiment/cells.hpp"
#include "reports/experiment/cells_text.hpp"

namespace tcert::cli {

struct CellResults {
  CellFiles files;
  std::vector<CellRows> scores;  ///< Per cell: H1 by panel, then issuance; empty if refused.
  std::vector<CellRows> speeds;  ///< Per cell: H3.
};

[[nodiscard]] study::H1Options h1_of(const CellsRequest& request, const study::ParameterSet& full);

/// Runs and scores cells. \pre the first one is the full method. `cache` may be null.
/// \throws UnfitData for a column that is not there; BadData under --strict.
[[nodiscard]] CellResults cell_results(const CellsRequest& request,
                                       const OpenedBundle& opened,
                                       std::span<const study::PlannedCell> cells,
                                       Cache* cache,
                                       Progress& progress);

/// The lines of cells [first, last) of `all`: scores, speeds, and the tables of trials of which the
/// cell is the first owner, tabs between; the first one ends with the trials that are rejected.
[[nodiscard]] std::vector<std::string> cell_lines(const CellsRequest& request,
                                                  const OpenedBundle& opened,
                                                  std::span<const study::PlannedCell> all,
                                                  std::size_t first,
                                                  std::size_t last,
                                                  Cache* cache,
                                                  Progress& progress);

/// Takes lines of cells, and has the results when all are taken.
class GatheredCells {
 public:
  GatheredCells(const OpenedBundle& opened, std::span<const study::PlannedCell> all);

  /// \throws table::RowError for a line that cell_lines() does not write.
  void take(std::size_t cell, std::string_view line);

  /// Reads the logs for their digest.
  [[nodiscard]] CellResults finish();

 private:
  const OpenedBundle& opened_;
  std::span<const study::PlannedCell> all_;
  CellResults results_;
  std::vector<bool> owns_features_;
  std::vector<bool> owns_replays_;
};

}  // namespace tcert::cli
