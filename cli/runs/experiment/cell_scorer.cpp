#include "cli/runs/experiment/cell_scorer.hpp"

#include <stdexcept>
#include <table/bytes.hpp>
#include <table/csv_write.hpp>
#include <table/read_data_table.hpp>
#include <utility>

#include "analysis/study/experiment/cell_scores.hpp"
#include "cli/runs/program_digest.hpp"
#include "reports/experiment/cells_table.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {
namespace {

table::DataTable table_of(const std::string& csv, const char* name) {
  table::CsvOptions options;
  options.file = name;
  table::DataTableResult read = table::read_data_table(table::Bytes::copy_of(csv), {}, options);
  if (!read.table) {
    throw std::logic_error("a table of a cell cannot be read back: " +
                           table::to_string(read.diagnostics.front()));
  }
  return std::move(*read.table);
}

}  // namespace

CellRows Scoring::kept(const std::string& key, const std::function<CellRows()>& make) const {
  const std::string digest = sha256("program " + program_digest() + '\n' + key);
  if (const auto stored = store != nullptr ? store->get(digest) : std::nullopt) {
    try {
      return cell_rows_from(*stored);
    } catch (const std::invalid_argument&) {
      // An entry that cannot be read is none.
    }
  }
  CellRows rows = make();
  if (store != nullptr) {
    store->put(digest, to_text(rows));
  }
  return rows;
}

const CellRows& FeatureScorer::rows(std::size_t cell, std::size_t full, double landmark_s) {
  if (!rows_[cell]) {
    rows_[cell] = scoring_.kept(key_of(cell, full, landmark_s),
                                [&] { return scored(cell, full, landmark_s); });
  }
  return *rows_[cell];
}

CellRows FeatureScorer::scored(std::size_t cell, std::size_t full, double landmark_s) {
  if (!full_) {
    full_ = table_of(scoring_.files.features[full], "features.csv");
  }
  std::optional<table::DataTable> own;
  if (cell != full) {
    own = table_of(scoring_.files.features[cell], "features.csv");
  }
  const study::CellScores scores =
      study::cell_scores(own ? *own : *full_, *full_, landmark_s, scoring_.h1);
  CellRows rows = cell_panels(scores);
  rows.push_back(cell_issuance(scores.issuance));
  return rows;
}

std::string FeatureScorer::key_of(std::size_t cell, std::size_t full, double landmark_s) const {
  const study::H1Options& h1 = scoring_.h1;
  // The full method has no changes from itself; a cell with the same features has changes of 0.
  std::string text = cell == full ? "scores of the full method\n" : "scores of a cell\n";
  for (const std::size_t table : {cell, full}) {
    text += sha256(scoring_.files.features[table]) + '\n';
  }
  text += h1.cluster + '\n' + h1.strata + '\n';
  text += std::to_string(h1.replicates) + ' ' + std::to_string(h1.seed) + '\n';
  table::append_number(text, h1.landmark_s);
  text += ' ';
  table::append_number(text, landmark_s);
  return text;
}

const CellRows& SpeedScorer::rows(std::size_t cell) {
  if (!rows_[cell]) {
    rows_[cell] = scoring_.kept(key_of(cell), [&] { return scored(cell); });
  }
  return *rows_[cell];
}

CellRows SpeedScorer::scored(std::size_t cell) const {
  const table::DataTable replays = table_of(scoring_.files.replays[cell], "replay.csv");
  std::vector<TableCell> row = cell_speed(study::hypothesis_h3(replays, scoring_.h3));
  return row.empty() ? CellRows{} : CellRows{std::move(row)};
}

std::string SpeedScorer::key_of(std::size_t cell) const {
  const study::H3Options& h3 = scoring_.h3;
  return "speed of a cell\n" + sha256(scoring_.files.replays[cell]) + '\n' + h3.cluster + '\n' +
         std::to_string(h3.replicates) + ' ' + std::to_string(h3.seed);
}

}  // namespace tcert::cli
