#include "cli/experiment/batch.hpp"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "analysis/experiment/cell_scores.hpp"
#include "analysis/model/expression.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/experiment/cell_files.hpp"
#include "cli/inputs.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/result_folder.hpp"
#include "datasets/bytes.hpp"
#include "datasets/csv_write.hpp"
#include "reports/experiment/cells_table.hpp"
#include "reports/features_table.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {
namespace {

constexpr const char* kFull = "full";

/// $XDG_CACHE_HOME/tcert, ~/.cache/tcert, or none.
std::optional<std::filesystem::path> user_cache() {
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
  };
  if (const auto cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) {
    return cache / "tcert";
  }
  if (const auto home = variable("HOME"); home.is_absolute()) {
    return home / ".cache" / "tcert";
  }
  return std::nullopt;
}

std::optional<ResultStore> store_of(const BatchOptions& options) {
  if (options.no_cache) {
    return std::nullopt;
  }
  if (!options.cache.empty()) {
    return ResultStore(options.cache);
  }
  const auto folder = user_cache();
  return folder ? std::optional(ResultStore(*folder)) : std::nullopt;
}

DataTable table_of(const std::string& csv) {
  CsvOptions options;
  options.file = "features.csv";
  DataTableResult read = read_data_table(Bytes::copy_of(csv), {}, options);
  if (!read.table) {
    throw std::logic_error("the features cannot be read back: " +
                           to_string(read.diagnostics.front()));
  }
  return std::move(*read.table);
}

H1Options h1_of(const BatchOptions& options,
                const CommonOptions& common,
                const ParameterSet& full) {
  H1Options h1;
  h1.cluster = options.cluster;
  h1.strata = options.strata;
  h1.replicates = static_cast<std::size_t>(options.replicates);
  h1.seed = static_cast<std::uint64_t>(common.seed);
  h1.landmark_s = full.early_window.time_s;
  return h1;
}

/// Scores of the features, each distinct table once; from the cache where they are there.
class Scorer {
 public:
  Scorer(const CellFiles& files, H1Options options, const ResultStore* store)
      : files_(files), options_(std::move(options)), store_(store), rows_(files.features.size()) {}

  /// `full` and `cell` are indices of tables of features.
  const CellRows& rows(std::size_t cell, std::size_t full, double landmark_s) {
    std::optional<CellRows>& rows = rows_[cell];
    if (!rows) {
      rows = scored(cell, full, landmark_s);
    }
    return *rows;
  }

 private:
  CellRows scored(std::size_t cell, std::size_t full, double landmark_s) {
    const std::string key = key_of(cell, full, landmark_s);
    if (const auto stored = store_ != nullptr ? store_->get(key) : std::nullopt) {
      return cell_rows_from(*stored);
    }
    if (!full_) {
      full_ = table_of(files_.features[full]);
    }
    CellRows rows;
    if (cell == full) {
      rows = cell_rows(cell_scores(*full_, *full_, landmark_s, options_));
    } else {
      rows = cell_rows(cell_scores(table_of(files_.features[cell]), *full_, landmark_s, options_));
    }
    if (store_ != nullptr) {
      store_->put(key, to_text(rows));
    }
    return rows;
  }

  [[nodiscard]] std::string key_of(std::size_t cell, std::size_t full, double landmark_s) const {
    // The full method has no changes from itself; a cell with the same features has changes of 0.
    std::string text = cell == full ? "scores of the full method\n" : "scores of a cell\n";
    text += "program " + program_digest() + '\n';
    for (const std::size_t table : {cell, full}) {
      text += sha256(files_.features[table]) + '\n';
    }
    text += options_.cluster + '\n' + options_.strata + '\n';
    text += std::to_string(options_.replicates) + ' ' + std::to_string(options_.seed) + '\n';
    append_number(text, options_.landmark_s);
    text += ' ';
    append_number(text, landmark_s);
    return sha256(text);
  }

  const CellFiles& files_;
  H1Options options_;
  const ResultStore* store_;
  std::vector<std::optional<CellRows>> rows_;
  std::optional<DataTable> full_;
};

std::vector<PlannedCell> planned(std::vector<Cell> cells, const OpenedBundle& opened) {
  cells.insert(cells.begin(), Cell{kFull, {}});
  std::set<std::string> names;
  std::vector<PlannedCell> result;
  for (Cell& cell : cells) {
    if (!names.insert(cell.name).second) {
      throw UsageError("two cells are called '" + cell.name + "'");
    }
    result.push_back(plan(
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
};

BatchTables tables_of(const std::vector<PlannedCell>& cells,
                      const CellFiles& files,
                      const H1Options& h1,
                      const ResultStore* store,
                      const CommonOptions& common) {
  BatchTables tables{cells_table({h1.level, h1.replicates, h1.cluster}), cell_issuance_table()};
  Scorer scorer(files, h1, store);
  Progress progress("cells", cells.size(), common.quiet);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const PlannedCell& cell = cells[c];
    if (cell.refused()) {
      const std::string& reason = std::get<std::string>(cell.parameters);
      say("cell '" + cell.cell.name + "' is refused: " + reason);
      add_cell(cell.cell, "refused: " + reason, {}, tables.cells, tables.issuance);
    } else {
      const CellRows& rows = scorer.rows(
          files.features_of[c], files.features_of.front(), cell.set().early_window.time_s);
      add_cell(cell.cell, "done", rows, tables.cells, tables.issuance);
    }
    progress.advance();
  }
  return tables;
}

void say_reuse(const CellFiles& files, const std::vector<PlannedCell>& cells) {
  const auto part = [](const char* name, const ReuseCount& count) {
    return std::string(name) + ' ' + std::to_string(count.done) + " done, " +
           std::to_string(count.reused) + " shared";
  };
  say(std::to_string(cells.size()) + " cells, " + std::to_string(files.features.size()) +
      " distinct tables of features; of their parts " + std::to_string(files.from_cache) +
      " from the cache, " + std::to_string(files.made) + " made: " +
      part("logs", files.reuse.read) + "; " + part("ticks", files.reuse.resample) + "; " +
      part("series", files.reuse.certify) + "; " + part("features", files.reuse.features) + '.');
}

/// "features/007.csv": cells that share features share the file.
std::string features_name(std::size_t table) {
  std::string number = std::to_string(table);
  number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
  return "features/" + number + ".csv";
}

Table files_table(const std::vector<PlannedCell>& cells, const CellFiles& files) {
  Table table;
  table.name = "files";
  table.columns = {{"cell", "cell", "", ColumnKind::text},
                   {"features", "features", "", ColumnKind::text}};
  for (std::size_t c = 0; c < cells.size(); ++c) {
    table.add_row(
        {cells[c].cell.name,
         cells[c].refused() ? TableCell{} : TableCell{features_name(files.features_of[c])}});
  }
  return table;
}

void write_folder(const std::string& command,
                  const OpenedBundle& opened,
                  const CommonOptions& common,
                  const std::vector<PlannedCell>& cells,
                  const CellFiles& files,
                  const BatchTables& tables,
                  ResultFolder& folder) {
  folder.write("cells.csv", render(tables.cells, TableFormat::csv));
  folder.write("issuance.csv", render(tables.issuance, TableFormat::csv));
  folder.write("files.csv", render(files_table(cells, files), TableFormat::csv));
  for (std::size_t table = 0; table < files.features.size(); ++table) {
    folder.write(features_name(table), files.features[table]);
  }
  Manifest manifest;
  manifest.command = command;
  manifest.options = common.effective;
  manifest.parameters = as_settings(opened.parameters, opened.bundle.info.robot);
  manifest.synthetic = synthetic_label(opened.bundle.info);
  manifest.seed = static_cast<std::uint64_t>(common.seed);
  manifest.inputs = files.inputs;
  folder.commit(std::move(manifest));
}

}  // namespace

void add_batch_options(po::options_description& own, BatchOptions& o) {
  const auto text = [](std::string& value, const char* name) {
    return po::value(&value)->value_name(name);
  };
  auto add = own.add_options();
  add("cells",
      text(o.cells, "FILE"),
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
      text(o.cache, "DIR"),
      "where results are kept for the next run; the user's cache folder unless given");
  add("no-cache", po::bool_switch(&o.no_cache), "neither read nor write the cache");
  add("table",
      text(o.table, "NAME"),
      "what is printed without --output: cells (as it is without) or issuance");
}

std::vector<Cell> cells_of_file(const std::string& path, const CommonOptions& common) {
  const DataFile file = read_data_file(path, {}, common);
  std::vector<Cell> cells(file.table.rows);
  for (std::size_t row = 0; row < cells.size(); ++row) {
    cells[row].name = "row " + std::to_string(row + 1);
  }
  for (const DataColumn& column : file.table.columns) {
    for (std::size_t row = 0; row < cells.size(); ++row) {
      std::string value;
      if (!column.is_text) {
        append_number(value, column.numbers[row]);
      } else if (column.text.codes[row] != Factor::kMissing) {
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
              std::vector<Cell> cells) {
  require_range("replicates", static_cast<double>(options.replicates), 1, 1e6);
  if (!options.table.empty() && options.table != "cells" && options.table != "issuance") {
    throw UsageError("--table: found '" + options.table + "', expected cells or issuance");
  }
  const OpenedBundle opened = open_for(options.bundle, common);
  const std::vector<PlannedCell> batch = planned(std::move(cells), opened);
  std::optional<ResultFolder> folder;
  if (!common.output.empty()) {
    require_apart(options.bundle, common.output);
    folder.emplace(common.output, command);
  }
  const ThreadLimit threads(common.threads);
  const std::optional<ResultStore> store = store_of(options);
  const ResultStore* const kept = store ? &*store : nullptr;
  const CellFiles files = files_of_cells(opened, common, batch, kept);
  BatchTables tables;
  try {
    tables = tables_of(batch, files, h1_of(options, common, opened.parameters), kept, common);
  } catch (const FormulaError& error) {
    throw UsageError(error.what());
  }
  tables.cells.synthetic = tables.issuance.synthetic = synthetic_label(opened.bundle.info);
  if (!common.quiet) {
    say_reuse(files, batch);
  }
  for (const std::string& id : files.rejected) {
    say("trial '" + id + "' is rejected");
  }
  if (folder) {
    write_folder(command, opened, common, batch, files, tables, *folder);
  } else {
    print(render(options.table == "issuance" ? tables.issuance : tables.cells,
                 common.table_format()));
  }
  const bool refused = std::any_of(
      batch.begin(), batch.end(), [](const PlannedCell& cell) { return cell.refused(); });
  const bool bad_rows = has_error(opened.diagnostics);
  return refused || bad_rows || !files.rejected.empty() ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
