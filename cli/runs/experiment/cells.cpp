#include "cli/runs/experiment/cells.hpp"

#include "analysis/study/experiment/paper_cells.hpp"
#include "cli/runs/experiment/asked_cells.hpp"
#include "cli/runs/experiment/run_cells.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert::cli {
namespace {

void add_cells_options(OptionTable& table, CellsRequest& o) {
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

/// True if the first of the trials that can be read has slope, step or slip. What is wrong with the
/// bundle is said by whoever reads all of it.
bool has_footing(const std::string& path, const LogOptions& logs) {
  const BundleResult opened = open_bundle(path, {logs.decimal_comma});
  if (!opened.bundle) {
    return false;
  }
  for (const TrialRow& row : opened.bundle->trials) {
    if (const TrialResult trial = read_trial(*opened.bundle, row, {logs.repair}); trial.log) {
      return trial.log->merged ? !trial.log->merged->footing.empty()
                               : !trial.log->pose.footing.empty();
    }
  }
  return false;
}

std::vector<study::Cell> cells_of(const AblateRequest& request, Progress& progress) {
  if (!request.cells.empty()) {
    return cells_of_file(request, progress);
  }
  std::vector<study::Cell> cells = study::ablation_cells();
  if (has_footing(request.bundle, request.logs)) {
    cells.push_back(study::footing_ablation());
  }
  return cells;
}

std::vector<study::Cell> cells_of(const SweepRequest& request, Progress& progress) {
  const int sources = (request.grid.empty() ? 0 : 1) + (request.cells.empty() ? 0 : 1) +
                      (request.sensitivity ? 1 : 0);
  if (sources != 1) {
    throw UsageError("needs one of --grid, --cells and --sensitivity");
  }
  return request.sensitivity     ? study::sensitivity_cells()
         : !request.grid.empty() ? cells_of_grid(request.grid)
                                 : cells_of_file(request, progress);
}

CellsRun run_of(const AblateRequest& request) { return {"ablate", request, written(request)}; }

CellsRun run_of(const SweepRequest& request) {
  return {"sweep", request, written(request), !request.grid.empty()};
}

}  // namespace

OptionTable options_of(AblateRequest& request) {
  OptionTable table(request.given);
  add_cells_options(table, request);
  return table;
}

ExitCode ablate(const AblateRequest& request, Progress& progress) {
  return run_cells(run_of(request), cells_of(request, progress), progress);
}

ExitCode ablate(const AblateRequest& request, Progress& progress, const ItemSource& source) {
  return run_cells(run_of(request), cells_of(request, progress), progress, &source);
}

std::vector<ItemSet> items_of(const AblateRequest& request, Progress& progress) {
  return {items_of_cells(run_of(request), cells_of(request, progress), progress)};
}

OptionTable options_of(SweepRequest& request) {
  OptionTable table(request.given);
  table.add(
      "grid", request.grid, "KEY=VALUES", "a parameter and its values, comma between; repeatable");
  table.add(
      "sensitivity", request.sensitivity, "every choice that the paper leaves open, one at a time");
  add_cells_options(table, request);
  return table;
}

ExitCode sweep(const SweepRequest& request, Progress& progress) {
  return run_cells(run_of(request), cells_of(request, progress), progress);
}

ExitCode sweep(const SweepRequest& request, Progress& progress, const ItemSource& source) {
  return run_cells(run_of(request), cells_of(request, progress), progress, &source);
}

std::vector<ItemSet> items_of(const SweepRequest& request, Progress& progress) {
  return {items_of_cells(run_of(request), cells_of(request, progress), progress)};
}

}  // namespace tcert::cli
