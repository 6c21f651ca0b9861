#include "datasets/import/trial_outcomes.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <table/csv.hpp>
#include <table/nearest_name.hpp>
#include <table/text_file.hpp>
#include <utility>

#include "datasets/import/outcome_cells.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;
using table::Severity;

/// The one run of digits in a name, as a number: 7 of "run_07". Empty if there is none, or several.
std::optional<long> only_number(const std::string& name) {
  const std::size_t first = name.find_first_of("0123456789");
  if (first == std::string::npos) {
    return std::nullopt;
  }
  std::size_t end = name.find_first_not_of("0123456789", first);
  end = std::min(end, name.size());
  if (name.find_first_of("0123456789", end) != std::string::npos || end - first > 9) {
    return std::nullopt;
  }
  return std::stol(name.substr(first, end - first));
}

std::optional<fs::path> place_of(const std::string& name, const std::vector<fs::path>& folders) {
  std::error_code ignored;
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / name, ignored)) {
      return folder / name;
    }
  }
  return std::nullopt;
}

/// The row of each trial; the number of rows if it has none.
std::vector<std::size_t> rows_of(const table::TextTable& table,
                                 std::size_t id,
                                 const Outcomes& outcomes,
                                 const std::vector<TrialRow>& trials,
                                 const std::string& file,
                                 table::DiagnosticGroups& problems) {
  std::map<std::string, std::size_t> by_name;
  std::map<long, std::vector<std::size_t>> by_number;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.at(row, id);
    if (!by_name.try_emplace(name, row).second) {
      outcomes.add(Severity::error, row, id, "one row a trial");
    }
    if (const auto number = only_number(name)) {
      by_number[*number].push_back(row);
    }
  }
  std::vector<std::size_t> rows(trials.size(), table.rows());
  bool any = false;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto found = by_name.find(trials[i].trial_id);
    if (found != by_name.end()) {
      rows[i] = found->second;
      any = true;
    }
  }
  if (any) {
    return rows;
  }
  std::map<long, std::size_t> trials_by_number;
  for (const TrialRow& trial : trials) {
    if (const auto number = only_number(trial.trial_id)) {
      ++trials_by_number[*number];
    }
  }
  std::size_t matched = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto number = only_number(trials[i].trial_id);
    const auto found = number ? by_number.find(*number) : by_number.end();
    if (found != by_number.end() && found->second.size() == 1 && trials_by_number[*number] == 1) {
      rows[i] = found->second.front();
      ++matched;
    }
  }
  if (matched > 0) {
    problems.add({Severity::note,
                  file,
                  0,
                  table.columns[id],
                  "no name of a trial, but numbers of " + std::to_string(matched) + " trials",
                  "names of trials; rows are taken by the number in them",
                  1});
  }
  return rows;
}

/// Words of the lists that no cell of the table has: misspelt, or of another column.
void warn_of_unused_words(const LogMap& map,
                          const table::TextTable& table,
                          const std::string& file,
                          table::DiagnosticGroups& problems) {
  for (const OutcomeSource& source : map.trials.outcomes) {
    std::vector<std::string> words = source.success_words;
    words.insert(words.end(), source.failure_words.begin(), source.failure_words.end());
    const std::size_t column = table.find(source.column).value();
    std::vector<std::string> cells;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      cells.push_back(table::case_folded(table.at(row, column)));
    }
    for (const std::string& word : words) {
      if (std::ranges::find(cells, table::case_folded(word)) == cells.end()) {
        const auto nearest = table::nearest_name(word, cells);
        problems.add({Severity::warning,
                      file,
                      0,
                      source.column,
                      "no cell '" + table::shortened(word) + "'",
                      "the words of the map in the table" +
                          (nearest ? "; did you mean '" + table::shortened(*nearest) + "'?" : ""),
                      1});
      }
    }
  }
}

}  // namespace

void read_outcomes(const LogMap& map,
                   const std::vector<fs::path>& folders,
                   bool decimal_comma,
                   std::vector<TrialRow>& trials,
                   table::DiagnosticGroups& problems) {
  if (map.trials.table.empty()) {
    return;
  }
  const auto place = place_of(map.trials.table, folders);
  const std::string file = place ? place->string() : map.trials.table;
  if (!place) {
    problems.add({Severity::error,
                  file,
                  0,
                  "",
                  "no file",
                  "the table of outcomes, beside the map or the source",
                  1});
    return;
  }
  table::CsvOptions csv;
  csv.file = file;
  csv.decimal_comma = decimal_comma;
  std::vector<std::string> wanted{map.trials.id};
  for (const OutcomeSource& source : map.trials.outcomes) {
    wanted.push_back(source.column);
  }
  const table::BytesResult bytes = table::read_text_file(*place);
  if (!bytes.bytes) {
    problems.add({Severity::error, file, 0, "", bytes.problem, "a readable file", 1});
    return;
  }
  const auto header = table::guess_header(bytes.bytes->view(), csv, problems);
  if (!header) {
    return;
  }
  const table::TextTable table = table::read_text_rows(*bytes.bytes, *header, csv, problems);
  const Outcomes outcomes(table, file, problems);
  bool all = true;
  for (const std::string& name : wanted) {
    all = outcomes.column(name).has_value() && all;
  }
  if (!all) {
    return;
  }
  const std::size_t id = table.find(map.trials.id).value();
  const std::vector<std::size_t> rows = rows_of(table, id, outcomes, trials, file, problems);
  std::vector<bool> is_used(table.rows(), false);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (rows[i] < table.rows()) {
      outcomes.fill(rows[i], map.trials.outcomes, trials[i]);
      is_used[rows[i]] = true;
    } else {
      problems.add({Severity::warning,
                    file,
                    0,
                    map.trials.id,
                    "no row of trial " + trials[i].trial_id,
                    "a row a trial; its outcome is not known",
                    1});
    }
  }
  warn_of_unused_words(map, table, file, problems);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!is_used[row]) {
      outcomes.add(Severity::note, row, id, "a trial of the source; the row is not used");
    }
  }
}

}  // namespace tcert::recording
