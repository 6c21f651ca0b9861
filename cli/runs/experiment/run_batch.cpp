#include "cli/experiment/batch.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <statistics/model/expression.hpp>
#include <table/csv_write.hpp>
#include <utility>

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/experiment/cache.hpp"
#include "cli/experiment/cell_files.hpp"
#include "cli/experiment/cell_scorer.hpp"
#include "cli/inputs.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/report_output.hpp"
#include "reports/experiment/cells_table.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

constexpr const char* kFull = "full";

/// Where the batch keeps its results, if anywhere.
std::optional<std::filesystem::path> cache_folder(const BatchOptions& options) {
  if (options.no_cache) {
    return std::nullopt;
  }
  return options.cache.empty() ? Cache::folder_of_user()
                               : std::optional<std::filesystem::path>(options.cache);
}

study::H3Options h3_of(const BatchOptions& options, const CommonOptions& common) {
  study::H3Options h3;
  h3.cluster = options.cluster;
  h3.replicates = static_cast<std::size_t>(options.replicates);
  h3.seed = static_cast<std::uint64_t>(common.seed);
  return h3;
}

study::H1Options h1_of(const BatchOptions& options,
                       const CommonOptions& common,
                       const study::ParameterSet& full) {
  study::H1Options h1;
  h1.cluster = options.cluster;
  h1.strata = options.strata;
  h1.replicates = static_cast<std::size_t>(options.replicates);
  h1.seed = static_cast<std::uint64_t>(common.seed);
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

struct BatchTables {
  Table cells;
  Table issuance;
  Table speed;

  [[nodiscard]] std::array<Table*, 3> all() { return {&cells, &issuance, &speed}; }
};

BatchTables tables_of(const std::vector<study::PlannedCell>& cells,
                      const Scoring& scoring,
                      const CommonOptions& common) {
  const BatchNotes notes{
      scoring.h1.level, scoring.h1.replicates, scoring.h1.cluster, scoring.h1.interval};
  BatchTables tables{cells_table(notes), cell_issuance_table(), cell_speed_table(notes)};
  FeatureScorer features(scoring);
  SpeedScorer speeds(scoring);
  Progress progress("cells", cells.size(), common.quiet);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const study::PlannedCell& cell = cells[c];
    if (cell.refused()) {
      const std::string& reason = std::get<std::string>(cell.parameters);
      say("cell '" + cell.cell.name + "' is refused: " + reason);
      for (Table* const table : tables.all()) {
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
    progress.advance();
  }
  return tables;
}

void say_reuse(const CellFiles& files, const std::vector<study::PlannedCell>& cells) {
  const auto part = [](const char* name, const study::ReuseCount& count) {
    return std::string(name) + ' ' + std::to_string(count.done) + " done, " +
           std::to_string(count.reused) + " shared";
  };
  say(std::to_string(cells.size()) + " cells, " + std::to_string(files.features.size()) +
      " distinct tables of features, " + std::to_string(files.replays.size()) +
      " of replays; of their parts " + std::to_string(files.from_cache) + " from the cache, " +
      std::to_string(files.made) + " made: " + part("logs", files.reuse.read) + "; " +
      part("ticks", files.reuse.resample) + "; " + part("series", files.reuse.certify) + "; " +
      part("features", files.reuse.features) + '.');
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

void write_folder(const std::string& command,
                  const OpenedBundle& opened,
                  const CommonOptions& common,
                  const std::vector<study::PlannedCell>& cells,
                  const CellFiles& files,
                  const BatchTables& tables,
                  const std::string& cells_file,
                  ResultFolder& folder) {
  for (const Table* const table : {&tables.cells, &tables.issuance, &tables.speed}) {
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
  manifest.command = command;
  record(common, manifest);
  manifest.parameters = as_settings(opened.parameters, opened.bundle.info.robot);
  manifest.synthetic = synthetic_label(opened.bundle.info);
  manifest.seed = static_cast<std::uint64_t>(common.seed);
  manifest.inputs = files.inputs;
  if (!cells_file.empty()) {
    manifest.inputs.push_back({name_of(cells_file), digest_file(cells_file)});
  }
  folder.commit(std::move(manifest));
}

}  // namespace

void add_batch_options(po::options_description& own, BatchOptions& o) {
  const auto text = [](std::string& value, const char* name) {
    return po::value(&value)->value_name(name);
  };
  auto add = own.add_options();
  add("cells",
      input(o.cells, "FILE"),
      "cells from a CSV file: a column 'cell' with names, every other column a parameter; an empty "
      "cell leaves it as it is");
  add("cluster",
      text(o.cluster, "COLUMN")->default_value(o.cluster),
      "trials that share a value are not independent; '' for none");
  add("strata",
      text(o.strata, "COLUMN")->default_value(o.strata),
      "of the stratified hazard ratio; '' for none");
  add("replicates",
      po::value(&o.replicates)->value_name("R")->default_value(o.replicates),
      "of the bootstrap; more for stable third digits");
  add("cache",
      process(o.cache, "DIR"),
      "where results are kept for the next run; the user's cache folder unless given");
  add("no-cache", process_switch(o.no_cache), "neither read nor write the cache");
  add("table",
      text(o.table, "NAME"),
      "what is printed without --output: cells (unless given), issuance or speed");
}

std::vector<study::Cell> cells_of_file(const std::string& path, const CommonOptions& common) {
  const DataFile file = read_data_file(path, {}, common);
  std::vector<study::Cell> cells(file.table.rows);
  for (std::size_t row = 0; row < cells.size(); ++row) {
    cells[row].name = "row " + std::to_string(row + 1);
  }
  for (const table::DataColumn& column : file.table.columns) {
    for (std::size_t row = 0; row < cells.size(); ++row) {
      std::string value;
      if (!column.is_text) {
        table::append_number(value, column.numbers[row]);
      } else if (column.text.codes[row] != table::Factor::kMissing) {
        value = column.text.levels[column.text.codes[row]];
      }
      const bool missing = value.empty() || value == "nan";
      if (column.name == "cell" && !missing) {
        cells[row].name = value;
      } else if (!missing) {
        cells[row].overrides.emplace_back(column.name, value);
      }
    }
  }
  return cells;
}

int run_batch(const std::string& command,
              const BatchOptions& options,
              const CommonOptions& common,
              std::vector<study::Cell> cells) {
  require_range("replicates", static_cast<double>(options.replicates), 1, 1e6);
  if (!options.table.empty() && options.table != "cells" && options.table != "issuance" &&
      options.table != "speed") {
    throw UsageError("--table: found '" + options.table + "', expected cells, issuance or speed");
  }
  const OpenedBundle opened = open_for(options.bundle, common);
  const std::vector<study::PlannedCell> batch = planned(std::move(cells), opened);
  std::optional<ResultFolder> folder;
  if (!common.output.empty()) {
    require_apart(options.bundle, common.output);
    folder.emplace(common.output, command);
  }
  const ThreadLimit threads(common.threads);
  std::optional<Cache> cache;
  if (const auto kept = cache_folder(options)) {
    cache.emplace(*kept);
  }
  Cache* const kept = cache ? &*cache : nullptr;
  const CellFiles files = files_of_cells(opened, common, batch, kept);
  BatchTables tables;
  try {
    const Scoring scoring{
        files, h1_of(options, common, opened.parameters), h3_of(options, common), kept};
    tables = tables_of(batch, scoring, common);
  } catch (const statistics::FormulaError& error) {
    throw UsageError(error.what());
  }
  for (Table* const table : tables.all()) {
    table->synthetic = synthetic_label(opened.bundle.info);
  }
  if (!common.quiet) {
    say_reuse(files, batch);
  }
  for (const std::string& id : files.rejected) {
    say("trial '" + id + "' is rejected");
  }
  if (folder) {
    write_folder(command, opened, common, batch, files, tables, options.cells, *folder);
  } else {
    const Table& shown = options.table == "issuance" ? tables.issuance
                         : options.table == "speed"  ? tables.speed
                                                     : tables.cells;
    print(render(shown, common.table_format()));
  }
  const bool refused = std::any_of(
      batch.begin(), batch.end(), [](const study::PlannedCell& cell) { return cell.refused(); });
  const bool bad_rows = table::has_error(opened.diagnostics);
  return refused || bad_rows || !files.rejected.empty() ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
