#include "cli/runs/experiment/cell_results.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <table/row_text.hpp>
#include <utility>

#include "cli/runs/bundle_digest.hpp"
#include "cli/runs/experiment/cell_jobs.hpp"
#include "cli/runs/experiment/cell_scorer.hpp"

namespace tcert::cli {
namespace {

using Json = nlohmann::json;

study::H3Options h3_of(const CellsRequest& request) {
  study::H3Options h3;
  h3.cluster = request.cluster;
  h3.replicates = static_cast<std::size_t>(request.replicates);
  h3.seed = static_cast<std::uint64_t>(request.seed);
  return h3;
}

/// True if no cell before has the same table.
bool is_first(const std::vector<std::size_t>& table_of, std::size_t cell) {
  const auto end = table_of.begin() + static_cast<std::ptrdiff_t>(cell);
  return table_of[cell] != kNoTable && std::find(table_of.begin(), end, table_of[cell]) == end;
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
                         Progress& progress) {
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
  std::vector<std::string> lines;
  for (std::size_t cell = first; cell < last; ++cell) {
    const std::size_t here = cell == 0 ? 0 : cell - begin + 1;
    Json line{{"scores", to_text(results.scores[here])}, {"speed", to_text(results.speeds[here])}};
    if (is_first(whole.features_of, cell)) {
      line["features"] = results.files.features[results.files.features_of[here]];
    }
    if (is_first(whole.replays_of, cell)) {
      line["replays"] = results.files.replays[results.files.replays_of[here]];
    }
    if (cell == 0) {
      line["rejected"] = results.files.rejected;
    }
    lines.push_back(line.dump());
  }
  return lines;
}

GatheredCells::GatheredCells(const OpenedBundle& opened, std::span<const study::PlannedCell> all)
    : opened_(opened) {
  results_.files = unmade_files(all);
  results_.scores.resize(all.size());
  results_.speeds.resize(all.size());
}

void GatheredCells::take(std::size_t cell, std::string_view line) try {
  const Json json = Json::parse(line);
  CellFiles& files = results_.files;
  results_.scores.at(cell) = cell_rows_from(json.at("scores").get<std::string>());
  results_.speeds.at(cell) = cell_rows_from(json.at("speed").get<std::string>());
  if (is_first(files.features_of, cell)) {
    files.features[files.features_of[cell]] = json.at("features").get<std::string>();
  }
  if (is_first(files.replays_of, cell)) {
    files.replays[files.replays_of[cell]] = json.at("replays").get<std::string>();
  }
  if (cell == 0) {
    files.rejected = json.at("rejected").get<std::vector<std::string>>();
  }
} catch (const Json::exception&) {
  throw table::RowError("found no results of a cell");
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
