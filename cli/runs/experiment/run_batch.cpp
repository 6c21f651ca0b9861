#include "cli/runs/experiment/run_batch.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <statistics/model/expression.hpp>
#include <utility>

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/experiment/cache.hpp"
#include "cli/runs/experiment/cell_files.hpp"
#include "cli/runs/experiment/cell_scorer.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/thread_limit.hpp"
#include "reports/experiment/cell_findings.hpp"
#include "reports/experiment/cells_table.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

constexpr const char* kFull = "full";

/// Where the batch keeps its results, if anywhere.
std::optional<std::filesystem::path> cache_folder(const BatchRequest& options, Progress& progress) {
  if (options.no_cache) {
    return std::nullopt;
  }
  return options.cache.empty() ? Cache::folder_of_user(progress)
                               : std::optional<std::filesystem::path>(options.cache);
}

study::H3Options h3_of(const BatchRequest& options) {
  study::H3Options h3;
  h3.cluster = options.cluster;
  h3.replicates = static_cast<std::size_t>(options.replicates);
  h3.seed = static_cast<std::uint64_t>(options.seed);
  return h3;
}

study::H1Options h1_of(const BatchRequest& options, const study::ParameterSet& full) {
  study::H1Options h1;
  h1.cluster = options.cluster;
  h1.strata = options.strata;
  h1.replicates = static_cast<std::size_t>(options.replicates);
  h1.seed = static_cast<std::uint64_t>(options.seed);
  h1.landmark_s = full.early_window.time_s;
  return h1;
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

struct BatchTables {
  Table cells;
  Table issuance;
  Table speed;
  Table findings;

  [[nodiscard]] std::array<Table*, 4> all() { return {&cells, &issuance, &speed, &findings}; }
};

BatchTables tables_of(const std::vector<study::PlannedCell>& cells,
                      const Scoring& scoring,
                      Progress& progress) {
  const BatchNotes notes{
      scoring.h1.level, scoring.h1.replicates, scoring.h1.cluster, scoring.h1.interval};
  BatchTables tables{cells_table(notes), cell_issuance_table(), cell_speed_table(notes), {}};
  FeatureScorer features(scoring);
  SpeedScorer speeds(scoring);
  Stage stage(progress, "cells", cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const study::PlannedCell& cell = cells[c];
    if (cell.refused()) {
      const auto& reason = std::get<std::string>(cell.parameters);
      for (Table* const table : {&tables.cells, &tables.issuance, &tables.speed}) {
        add_cell(cell.cell, "refused: " + reason, {}, *table);
      }
    } else {
      const CellFiles& files = scoring.files;
      CellRows rows = features.rows(
          files.features_of[c], files.features_of.front(), cell.set().early_window.time_s);
      const CellRows issuance{rows.back()};
      rows.pop_back();
      add_cell(cell.cell, "done", rows, tables.cells);
      add_cell(cell.cell, "done", issuance, tables.issuance);
      add_cell(cell.cell, "done", speeds.rows(files.replays_of[c]), tables.speed);
    }
    stage.advance();
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

void write_folder(Batch batch,
                  const OpenedBundle& opened,
                  const std::vector<study::PlannedCell>& cells,
                  const CellFiles& files,
                  const BatchTables& tables,
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
  manifest.command = std::move(batch.command);
  record(std::move(batch.written), manifest);
  manifest.parameters = as_settings(opened.parameters, opened.bundle.info.robot);
  manifest.synthetic = synthetic_label(opened.bundle.info);
  manifest.seed = static_cast<std::uint64_t>(batch.options.seed);
  manifest.inputs = files.inputs;
  if (const std::string& file = batch.options.cells; !file.empty()) {
    manifest.inputs.push_back({name_of(file), digest_file(file)});
  }
  folder.commit(std::move(manifest));
}

}  // namespace

ExitCode run_batch(Batch batch, std::vector<study::Cell> cells, Progress& progress) {
  const BatchRequest& options = batch.options;
  if (!options.table.empty() && options.table != "cells" && options.table != "issuance" &&
      options.table != "speed") {
    throw UsageError("--table: found '" + options.table + "', expected cells, issuance or speed");
  }
  const OpenedBundle opened = open_for(options.bundle, options.logs, progress);
  const std::vector<study::PlannedCell> planned_cells = planned(std::move(cells), opened);
  if (const auto value = batch.is_grid ? study::impossible_value(planned_cells) : std::nullopt) {
    throw UsageError("--grid: " + *value);
  }
  say_refused(planned_cells, progress);
  std::optional<ResultFolder> folder;
  if (!options.output.path.empty()) {
    require_apart(options.bundle, options.output.path);
    if (!options.cells.empty()) {
      require_apart(options.cells, options.output.path);
    }
    folder.emplace(options.output.path, batch.command);
  }
  const ThreadLimit limit(options.threads);
  std::optional<Cache> cache;
  if (const auto kept = cache_folder(options, progress)) {
    cache.emplace(*kept, progress);
  }
  Cache* const kept = cache ? &*cache : nullptr;
  const CellFiles files = files_of_cells(opened, options.threads, progress, planned_cells, kept);
  BatchTables tables;
  try {
    const Scoring scoring{files, h1_of(options, opened.parameters), h3_of(options), kept};
    tables = tables_of(planned_cells, scoring, progress);
  } catch (const statistics::FormulaError& error) {
    throw UnfitData(error.what());
  }
  for (Table* const table : tables.all()) {
    table->synthetic = synthetic_label(opened.bundle.info);
  }
  say_reuse(files, planned_cells, progress);
  for (const std::string& id : files.rejected) {
    progress.say("trial '" + id + "' is rejected");
  }
  const bool refused = std::ranges::any_of(planned_cells, &study::PlannedCell::refused);
  const bool bad_rows = table::has_error(opened.diagnostics);
  const ExitCode code = refused || bad_rows || !files.rejected.empty() ? exit_rejected : exit_done;
  if (folder) {
    write_folder(std::move(batch), opened, planned_cells, files, tables, *folder);
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
