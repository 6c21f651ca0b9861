#include "cli/runs/experiment/cell_results.hpp"

#include <algorithm>
#include <statistics/model/expression.hpp>
#include <stdexcept>
#include <table/row_text.hpp>
#include <utility>

#include "cli/runs/bundle_digest.hpp"
#include "cli/runs/experiment/cell_jobs.hpp"
#include "cli/runs/experiment/cell_scorer.hpp"

namespace tcert::cli {
namespace {

study::H3Options h3_of(const CellsRequest& request) {
  study::H3Options h3;
  h3.cluster = request.cluster;
  h3.replicates = static_cast<std::size_t>(request.replicates);
  h3.seed = static_cast<std::uint64_t>(request.seed);
  return h3;
}

/// Which cells are the first to have their table.
std::vector<bool> first_owners(const std::vector<std::size_t>& table_of, std::size_t tables) {
  std::vector<bool> has_owner(tables, false);
  std::vector<bool> is_first(table_of.size(), false);
  for (std::size_t cell = 0; cell < table_of.size(); ++cell) {
    if (table_of[cell] != kNoTable && !has_owner[table_of[cell]]) {
      has_owner[table_of[cell]] = is_first[cell] = true;
    }
  }
  return is_first;
}

/// Texts as fields of one line, whatever bytes they hold: tabs between them, and a backslash before
/// what stands for a tab, a line feed and a backslash.
std::string line_of(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) {
    line += &field == fields.data() ? "" : "\t";
    for (const char c : field) {
      line += c == '\\' ? "\\\\" : c == '\t' ? "\\t" : c == '\n' ? "\\n" : std::string(1, c);
    }
  }
  return line;
}

/// \throws table::RowError.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\t') {
      fields.emplace_back();
    } else if (line[i] != '\\') {
      fields.back() += line[i];
    } else {
      const char next = ++i < line.size() ? line[i] : ' ';
      if (next != '\\' && next != 't' && next != 'n') {
        throw table::RowError("found a backslash before something else");
      }
      fields.back() += next == 't' ? '\t' : next == 'n' ? '\n' : next;
    }
  }
  return fields;
}

}  // namespace

study::H1Options h1_of(const CellsRequest& request, const study::ParameterSet& full) {
  study::H1Options h1;
  h1.cluster = request.cluster;
  h1.strata = request.strata;
  h1.replicates = static_cast<std::size_t>(request.replicates);
  h1.seed = static_cast<std::uint64_t>(request.seed);
  h1.landmark_s = full.early_window.time_s;
  return h1;
}

CellResults cell_results(const CellsRequest& request,
                         const OpenedBundle& opened,
                         std::span<const study::PlannedCell> cells,
                         Cache* cache,
                         Progress& progress) try {
  CellResults results;
  results.files = files_of_cells(opened, request.threads, progress, cells, cache);
  const CellFiles& files = results.files;
  const Scoring scoring{files, h1_of(request, opened.parameters), h3_of(request), cache};
  FeatureScorer features(scoring);
  SpeedScorer speeds(scoring);
  results.scores.resize(cells.size());
  results.speeds.resize(cells.size());
  Stage stage(progress, "cells", cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!cells[c].refused()) {
      results.scores[c] = features.rows(
          files.features_of[c], files.features_of.front(), cells[c].set().early_window.time_s);
      results.speeds[c] = speeds.rows(files.replays_of[c]);
    }
    stage.advance();
  }
  return results;
} catch (const statistics::FormulaError& error) {
  throw UnfitData(error.what());
}

std::vector<std::string> cell_lines(const CellsRequest& request,
                                    const OpenedBundle& opened,
                                    std::span<const study::PlannedCell> all,
                                    std::size_t first,
                                    std::size_t last,
                                    Cache* cache,
                                    Progress& progress) {
  // The full method is what every cell is held against.
  std::vector<study::PlannedCell> cells{all.front()};
  const std::size_t begin = std::max<std::size_t>(first, 1);
  cells.insert(cells.end(),
               all.begin() + static_cast<std::ptrdiff_t>(begin),
               all.begin() + static_cast<std::ptrdiff_t>(std::max(last, begin)));
  const CellResults results = cell_results(request, opened, cells, cache, progress);
  const CellFiles whole = unmade_files(all);
  const std::vector<bool> owns_features = first_owners(whole.features_of, whole.features.size());
  const std::vector<bool> owns_replays = first_owners(whole.replays_of, whole.replays.size());
  std::vector<std::string> lines;
  for (std::size_t cell = first; cell < last; ++cell) {
    const std::size_t here = cell == 0 ? 0 : cell - begin + 1;
    const CellFiles& files = results.files;
    std::vector<std::string> fields{to_text(results.scores[here]), to_text(results.speeds[here])};
    fields.push_back(owns_features[cell] ? files.features[files.features_of[here]] : "");
    fields.push_back(owns_replays[cell] ? files.replays[files.replays_of[here]] : "");
    if (cell == 0) {
      fields.insert(fields.end(), files.rejected.begin(), files.rejected.end());
    }
    lines.push_back(line_of(fields));
  }
  return lines;
}

GatheredCells::GatheredCells(const OpenedBundle& opened, std::span<const study::PlannedCell> all)
    : opened_(opened), all_(all) {
  results_.files = unmade_files(all);
  results_.scores.resize(all.size());
  results_.speeds.resize(all.size());
  owns_features_ = first_owners(results_.files.features_of, results_.files.features.size());
  owns_replays_ = first_owners(results_.files.replays_of, results_.files.replays.size());
}

void GatheredCells::take(std::size_t cell, std::string_view line) try {
  std::vector<std::string> fields = fields_of(line);
  if (fields.size() < 4 || (cell > 0 && fields.size() > 4)) {
    throw table::RowError("found another number of fields");
  }
  CellFiles& files = results_.files;
  results_.scores.at(cell) = cell_rows_from(fields[0]);
  results_.speeds.at(cell) = cell_rows_from(fields[1]);
  if (results_.scores[cell].empty() != all_[cell].refused()) {
    throw table::RowError("found scores of a cell that is refused, or none of one that is not");
  }
  if (owns_features_[cell]) {
    files.features[files.features_of[cell]] = std::move(fields[2]);
  }
  if (owns_replays_[cell]) {
    files.replays[files.replays_of[cell]] = std::move(fields[3]);
  }
  if (cell == 0) {
    files.rejected.assign(fields.begin() + 4, fields.end());
  }
} catch (const std::invalid_argument&) {
  throw table::RowError("found no rows of a cell");
}

CellResults GatheredCells::finish() {
  ListDigest logs;
  for (const std::size_t trial : opened_.trials) {
    const TrialRow& row = opened_.bundle.trials[trial];
    logs.add(row.trial_id, log_digest(opened_.bundle, row));
  }
  results_.files.inputs = bundle_inputs(opened_.bundle, logs.finish());
  return std::move(results_);
}

}  // namespace tcert::cli
