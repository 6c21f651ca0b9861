#pragma once
/// \file
/// Running a batch of cells: what `ablate` and `sweep` have in common.

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/study/experiment/cell.hpp"
#include "cli/options.hpp"

namespace tcert::cli {

struct BatchOptions {
  std::string bundle;
  std::string cells;  ///< A CSV file of cells.
  std::string cache;  ///< Folder; empty: that of the user.
  bool no_cache = false;
  std::string cluster = "day";
  std::string strata = "algorithm";
  std::int64_t replicates = 2000;
  std::string table;
};

void add_batch_options(po::options_description& own, BatchOptions& o);

/// Cells of a CSV file: a column `cell` with names (rows are numbered without it), every other
/// column a parameter, an empty cell the value of the full method. \throws NoInput, BadData.
[[nodiscard]] std::vector<study::Cell> cells_of_file(const std::string& path,
                                                     const CommonOptions& common);

/// Runs the full method and then `cells`. A cell with impossible parameters is refused, the others
/// run. Prints the table, or writes the folder of results. The exit code: 3 if a cell was refused
/// or a trial rejected.
[[nodiscard]] int run_batch(const std::string& command,
                            const BatchOptions& options,
                            const CommonOptions& common,
                            std::vector<study::Cell> cells);

}  // namespace tcert::cli
