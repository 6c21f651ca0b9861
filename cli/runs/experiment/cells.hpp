#pragma once
/// \file
/// `ablate` and `sweep`: cells, one after the other.

#include <cstdint>
#include <string>
#include <vector>

#include "cli/runs/errors.hpp"
#include "cli/runs/items.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

/// What both have in common.
struct CellsRequest {
  std::string bundle;
  std::string cells;  ///< A CSV file of cells.
  std::string cluster = "day";
  std::string strata = "algorithm";
  std::int64_t replicates = 2000;
  std::string cache;  ///< Folder; empty: that of the user.
  bool no_cache = false;
  std::string table;
  OutputOptions output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

struct AblateRequest : CellsRequest {};

struct SweepRequest : CellsRequest {
  std::vector<std::string> grid;  ///< KEY=V1,V2,...
  bool sensitivity = false;
};

[[nodiscard]] OptionTable options_of(AblateRequest& request);
[[nodiscard]] OptionTable options_of(SweepRequest& request);

/// The full method, then the cells. A cell with impossible parameters is refused, the others run;
/// the exit code is 3 if a cell was refused or a trial rejected.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode ablate(const AblateRequest& request, Progress& progress);
[[nodiscard]] ExitCode sweep(const SweepRequest& request, Progress& progress);
/// The same of cells that were run elsewhere.
[[nodiscard]] ExitCode ablate(const AblateRequest& request,
                              Progress& progress,
                              const ItemSource& source);
[[nodiscard]] ExitCode sweep(const SweepRequest& request,
                             Progress& progress,
                             const ItemSource& source);

/// The cells, in pieces; the full method is the first. \throws UsageError, NoInput, BadData.
[[nodiscard]] std::vector<ItemSet> items_of(const AblateRequest& request, Progress& progress);
[[nodiscard]] std::vector<ItemSet> items_of(const SweepRequest& request, Progress& progress);

}  // namespace tcert::cli
