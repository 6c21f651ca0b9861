#include "cli/runs/experiment/batch.hpp"

#include "analysis/study/experiment/paper_cells.hpp"
#include "cli/runs/experiment/asked_cells.hpp"
#include "cli/runs/experiment/run_batch.hpp"

namespace tcert::cli {
namespace {

void add_batch_options(OptionTable& table, BatchRequest& o) {
  table.argument({"BUNDLE", &o.bundle, true, OptionRole::input});
  table.add_input("cells",
                  o.cells,
                  "FILE",
                  "cells from a CSV file: a column 'cell' with names, every other column a "
                  "parameter; an empty cell leaves it as it is");
  table.add(
      "cluster", o.cluster, "COLUMN", "trials that share a value are not independent; '' for none");
  table.add("strata", o.strata, "COLUMN", "of the stratified hazard ratio; '' for none");
  table.add("replicates", o.replicates, "R", "of the bootstrap; more for stable third digits")
      .within(1, 1e6);
  table.add_process(
      "cache",
      o.cache,
      "DIR",
      "where results are kept for the next run; the user's cache folder unless given");
  table.add_process("no-cache", o.no_cache, "", "neither read nor write the cache");
  table.add("table",
            o.table,
            "NAME",
            "what is printed without --output: cells (unless given), issuance or speed");
  add_common(table, o);
}

}  // namespace

OptionTable options_of(AblateRequest& request) {
  OptionTable table(request.given);
  add_batch_options(table, request);
  return table;
}

ExitCode ablate(const AblateRequest& request, Progress& progress) {
  return run_batch(
      {"ablate", request, written(request)},
      request.cells.empty() ? study::ablation_cells() : cells_of_file(request, progress),
      progress);
}

OptionTable options_of(SweepRequest& request) {
  OptionTable table(request.given);
  table.add(
      "grid", request.grid, "KEY=VALUES", "a parameter and its values, comma between; repeatable");
  table.add(
      "sensitivity", request.sensitivity, "every choice that the paper leaves open, one at a time");
  add_batch_options(table, request);
  return table;
}

ExitCode sweep(const SweepRequest& request, Progress& progress) {
  const int sources = (request.grid.empty() ? 0 : 1) + (request.cells.empty() ? 0 : 1) +
                      (request.sensitivity ? 1 : 0);
  if (sources != 1) {
    throw UsageError("needs one of --grid, --cells and --sensitivity");
  }
  return run_batch({"sweep", request, written(request), !request.grid.empty()},
                   request.sensitivity     ? study::sensitivity_cells()
                   : !request.grid.empty() ? cells_of_grid(request.grid)
                                           : cells_of_file(request, progress),
                   progress);
}

}  // namespace tcert::cli
