#include "cli/runs/experiment/run_cells.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "cli/runs/errors.hpp"
#include "cli/runs/experiment/cache.hpp"
#include "cli/runs/experiment/cell_results.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/thread_limit.hpp"
#include "reports/experiment/cell_findings.hpp"
#include "reports/experiment/cells_table.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

constexpr const char* kFull = "full";

/// Where the results are kept for the next run, if anywhere.
std::optional<std::filesystem::path> cache_folder(const CellsRequest& options, Progress& progress) {
  if (options.no_cache) {
    return std::nullopt;
  }
  return options.cache.empty() ? Cache::folder_of_user(progress)
                               : std::optional<std::filesystem::path>(options.cache);
}

std::vector<study::PlannedCell> planned(std::vector<study::Cell> cells,
                                        const OpenedBundle& opened) {
  cells.insert(cells.begin(), study::Cell{kFull, {}});
  std::set<std::string> names;
  std::vector<study::PlannedCell> result;
  for (study::Cell& cell : cells) {
    if (!names.insert(cell.name).second) {
      throw UsageError("two cells are called '" + cell.name + "'");
    }
    result.push_back(study::plan(
        std::move(cell), opened.parameters, opened.bundle.info.robot, opened.bundle.info.course));
  }
  if (result.front().refused()) {
    throw UsageError(std::get<std::string>(result.front().parameters));
  }
  return result;
}

/// Before the others run, which may take long.
void say_refused(const std::vector<study::PlannedCell>& cells, Progress& progress) {
  for (const study::PlannedCell& cell : cells) {
    if (cell.refused()) {
      progress.say("cell '" + cell.cell.name +
                   "' is refused: " + std::get<std::string>(cell.parameters));
    }
  }
}

struct CellTables {
  Table cells;
  Table issuance;
  Table speed;
  Table findings;

  [[nodiscard]] std::array<Table*, 4> all() { return {&cells, &issuance, &speed, &findings}; }
};

CellTables tables_of(const std::vector<study::PlannedCell>& cells,
                     const CellResults& results,
                     const study::H1Options& h1) {
  const CellNotes notes{h1.level, h1.replicates, h1.cluster, h1.interval};
  CellTables tables{cells_table(notes), cell_issuance_table(), cell_speed_table(notes), {}};
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const study::PlannedCell& cell = cells[c];
    if (cell.refused()) {
      const auto& reason = std::get<std::string>(cell.parameters);
      for (Table* const table : {&tables.cells, &tables.issuance, &tables.speed}) {
        add_cell(cell.cell, "refused: " + reason, {}, *table);
      }
    } else if (results.scores[c].empty()) {
      for (Table* const table : {&tables.cells, &tables.issuance, &tables.speed}) {
        add_cell(cell.cell, "not run", {}, *table);
      }
    } else {
      CellRows rows = results.scores[c];
      const CellRows issuance{rows.back()};
      rows.pop_back();
      add_cell(cell.cell, "done", rows, tables.cells);
      add_cell(cell.cell, "done", issuance, tables.issuance);
      add_cell(cell.cell, "done", results.speeds[c], tables.speed);
    }
  }
  tables.findings = cell_findings(tables.cells, tables.issuance);
  return tables;
}

void say_reuse(const CellFiles& files,
               const std::vector<study::PlannedCell>& cells,
               Progress& progress) {
  const auto part = [](const char* name, const study::ReuseCount& count) {
    return std::string(name) + ' ' + std::to_string(count.done) + " done, " +
           std::to_string(count.reused) + " shared";
  };
  progress.sum_up(std::to_string(cells.size()) + " cells, " +
                  std::to_string(files.features.size()) + " distinct tables of features, " +
                  std::to_string(files.replays.size()) + " of replays; of their parts " +
                  std::to_string(files.from_cache) + " from the cache, " +
                  std::to_string(files.made) + " made: " + part("logs", files.reuse.read) + "; " +
                  part("ticks", files.reuse.resample) + "; " + part("series", files.reuse.certify) +
                  "; " + part("features", files.reuse.features) + '.');
}

/// "features/007.csv": cells that share a table share the file.
std::string file_name(const char* folder, std::size_t table) {
  std::string number = std::to_string(table);
  number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
  return std::string(folder) + '/' + number + ".csv";
}

Table files_table(const std::vector<study::PlannedCell>& cells,
                  const CellFiles& files,
                  const std::optional<SyntheticLabel>& synthetic) {
  Table table;
  table.name = "files";
  table.synthetic = synthetic;
  table.columns = {{"cell", "cell", "", ColumnKind::text},
                   {"features", "features", "", ColumnKind::text},
                   {"replays", "replays", "", ColumnKind::text}};
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].refused()) {
      table.add_row({cells[c].cell.name, TableCell{}, TableCell{}});
    } else {
      table.add_row({cells[c].cell.name,
                     file_name("features", files.features_of[c]),
                     file_name("replays", files.replays_of[c])});
    }
  }
  return table;
}

void write_folder(CellsRun run,
                  const OpenedBundle& opened,
                  const std::vector<study::PlannedCell>& cells,
                  const CellFiles& files,
                  const CellTables& tables,
                  ResultFolder& folder) {
  for (const Table* const table :
       {&tables.findings, &tables.cells, &tables.issuance, &tables.speed}) {
    write_table(*table, folder);
  }
  const auto label = synthetic_label(opened.bundle.info);
  folder.write("files.csv", render(files_table(cells, files, label), TableFormat::csv));
  for (std::size_t table = 0; table < files.features.size(); ++table) {
    folder.write(file_name("features", table), files.features[table]);
  }
  for (std::size_t table = 0; table < files.replays.size(); ++table) {
    folder.write(file_name("replays", table), files.replays[table]);
  }
  Manifest manifest;
  manifest.command = std::move(run.command);
  record(std::move(run.written), manifest);
  manifest.parameters = as_settings(opened.parameters, opened.bundle.info.robot);
  manifest.synthetic = synthetic_label(opened.bundle.info);
  manifest.seed = static_cast<std::uint64_t>(run.options.seed);
  manifest.inputs = files.inputs;
  if (const std::string& file = run.options.cells; !file.empty()) {
    manifest.inputs.push_back({name_of(file), digest_file(file)});
  }
  folder.commit(std::move(manifest));
}

/// Cells of a bundle, none of them run.
struct OpenedCells {
  OpenedBundle opened;
  std::vector<study::PlannedCell> cells;
};

OpenedCells open_cells(const CellsRun& run, std::vector<study::Cell> cells, Progress& progress) {
  if (const std::string& table = run.options.table;
      !table.empty() && table != "cells" && table != "issuance" && table != "speed") {
    throw UsageError("--table: found '" + table + "', expected cells, issuance or speed");
  }
  OpenedBundle opened = open_for(run.options.bundle, run.options.logs, progress);
  std::vector<study::PlannedCell> all = planned(std::move(cells), opened);
  if (const auto value = run.is_grid ? study::impossible_value(all) : std::nullopt) {
    throw UsageError("--grid: " + *value);
  }
  say_refused(all, progress);
  return {std::move(opened), std::move(all)};
}

/// Runs `work` with the cache, or with none.
template <class Work>
auto with_cache(const CellsRequest& options, Progress& progress, const Work& work) {
  std::optional<Cache> cache;
  if (const auto folder = cache_folder(options, progress)) {
    cache.emplace(*folder, progress);
  }
  return work(cache ? &*cache : nullptr);
}

/// The lines of cells as items. \pre `options` and `opened` outlive them.
ItemSet item_set(const CellsRequest& options, const OpenedCells& opened, Progress& progress) {
  const auto make = [&options, &opened, &progress](std::uint64_t first,
                                                   std::uint64_t last,
                                                   const std::function<void()>& /*done*/) {
    OnlyWords words(progress);  // How far it is counts the items alone.
    return with_cache(options, words, [&](Cache* cache) {
      return cell_lines(options, opened.opened, opened.cells, first, last, cache, words);
    });
  };
  return {"cells", opened.cells.size(), opened.cells.size(), make};
}

CellResults results_of(const CellsRequest& options,
                       const OpenedCells& opened,
                       const ItemSource* source,
                       Progress& progress) {
  if (source != nullptr) {
    GatheredCells gathered(opened.opened, opened.cells);
    (*source)({item_set(options, opened, progress)},
              [&](std::size_t /*set*/, std::uint64_t cell, std::string_view line) {
                gathered.take(cell, line);
              });
    return gathered.finish();
  }
  CellResults results = with_cache(options, progress, [&](Cache* cache) {
    return cell_results(options, opened.opened, opened.cells, cache, progress);
  });
  say_reuse(results.files, opened.cells, progress);
  return results;
}

}  // namespace

ItemSet items_of_cells(const CellsRun& run, std::vector<study::Cell> cells, Progress& progress) {
  struct Held {
    CellsRequest options;
    OpenedCells opened;
  };
  const auto held =
      std::make_shared<const Held>(Held{run.options, open_cells(run, std::move(cells), progress)});
  ItemSet items = item_set(held->options, held->opened, progress);
  items.make = [held, make = std::move(items.make)](
                   std::uint64_t first, std::uint64_t last, const std::function<void()>& done) {
    return make(first, last, done);
  };
  return items;
}

ExitCode run_cells(CellsRun run,
                   std::vector<study::Cell> cells,
                   Progress& progress,
                   const ItemSource* source) {
  const CellsRequest& options = run.options;
  const OpenedCells all = open_cells(run, std::move(cells), progress);
  const OpenedBundle& opened = all.opened;
  std::optional<ResultFolder> folder;
  if (!options.output.path.empty()) {
    require_apart(options.bundle, options.output.path);
    if (!options.cells.empty()) {
      require_apart(options.cells, options.output.path);
    }
    folder.emplace(options.output.path, run.command);
  }
  const ThreadLimit limit(options.threads);
  const CellResults results = results_of(options, all, source, progress);
  CellTables tables = tables_of(all.cells, results, h1_of(options, opened.parameters));
  const CellFiles& files = results.files;
  for (Table* const table : tables.all()) {
    table->synthetic = synthetic_label(opened.bundle.info);
  }
  for (const std::string& id : files.rejected) {
    progress.say("trial '" + id + "' is rejected");
  }
  const bool refused = std::ranges::any_of(all.cells, &study::PlannedCell::refused);
  const bool bad_rows = table::has_error(opened.diagnostics);
  const ExitCode code = refused || bad_rows || !files.rejected.empty() ? exit_rejected : exit_done;
  if (folder) {
    write_folder(std::move(run), opened, all.cells, files, tables, *folder);
    sum_up(tables.findings, progress);
    return code;
  }
  const Table& shown = options.table == "issuance" ? tables.issuance
                       : options.table == "speed"  ? tables.speed
                                                   : tables.cells;
  show_found(shown, tables.findings, options.output, progress);
  return code;
}

}  // namespace tcert::cli
