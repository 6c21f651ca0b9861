#include "datasets/import/trial_outcomes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <table/cell_reading.hpp>
#include <table/csv.hpp>
#include <table/nearest_name.hpp>
#include <table/outcome_word.hpp>
#include <table/text_file.hpp>
#include <utility>

#include "datasets/trial_table.hpp"

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

/// The table of outcomes, and where its problems are.
class Outcomes {
 public:
  Outcomes(const table::TextTable& table, std::string file, table::DiagnosticGroups& problems)
      : table_(table), file_(std::move(file)), problems_(problems) {}

  [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const {
    const auto found = table_.find(name);
    if (!found) {
      const auto nearest = table::nearest_name(name, table_.columns);
      problems_.add({Severity::error,
                     file_,
                     0,
                     name,
                     nearest.value_or(""),
                     "a column of this name, or of another in the map",
                     1});
    }
    return found;
  }

  void add(Severity severity, std::size_t row, std::size_t column, std::string expectation) const {
    problems_.add({severity,
                   file_,
                   table_.lines[row],
                   table_.columns[column],
                   table::shortened(table_.at(row, column)),
                   std::move(expectation),
                   1});
  }

  [[nodiscard]] std::optional<bool> success(std::size_t row,
                                            std::size_t column,
                                            const OutcomeSource& source) const {
    const std::string word = table::case_folded(table_.at(row, column));
    const auto holds = [&word](const std::vector<std::string>& words) {
      return std::ranges::any_of(
          words, [&](const std::string& one) { return table::case_folded(one) == word; });
    };
    const bool listed = !source.success_words.empty() || !source.failure_words.empty();
    if (table::is_missing_cell(table_.at(row, column))) {
      return std::nullopt;
    }
    if (listed) {
      if (holds(source.success_words)) {
        return true;
      }
      if (holds(source.failure_words) ||
          (source.failure_words.empty() && !source.success_words.empty())) {
        return false;
      }
      if (source.success_words.empty()) {
        return true;
      }
      add(Severity::error, row, column, "a word of the lists 'true' and 'false' in the map");
      return std::nullopt;
    }
    switch (table::outcome_of_cell(table_.at(row, column))) {
      case table::OutcomeWord::success:
        return true;
      case table::OutcomeWord::failure:
        return false;
      case table::OutcomeWord::missing:
        return std::nullopt;
      case table::OutcomeWord::unknown:
        break;
    }
    add(Severity::error,
        row,
        column,
        std::string(table::kOutcomeWords) + "; or 'true' in the map, a list of words");
    return std::nullopt;
  }

  [[nodiscard]] std::optional<double> number(std::size_t row,
                                             std::size_t column,
                                             double scale) const {
    const auto reading = table::read_cell(table_.at(row, column), table_.dialect.decimal_point);
    if (reading.meaning == table::CellMeaning::number && std::isfinite(reading.value)) {
      return reading.value * scale;
    }
    if (reading.meaning != table::CellMeaning::missing) {
      add(Severity::error, row, column, "a number");
    }
    return std::nullopt;
  }

  void fill(std::size_t row, const std::vector<OutcomeSource>& sources, TrialRow& trial) const {
    for (const OutcomeSource& source : sources) {
      const std::size_t place = table_.find(source.column).value();
      const std::string& cell = table_.at(row, place);
      const std::string& name = source.name;
      if (name == "success") {
        trial.success = success(row, place, source);
      } else if (name == "time_s") {
        trial.time_s = number(row, place, source.scale);
      } else if (name == "distance_m") {
        trial.distance_m = number(row, place, source.scale);
      } else if (name == "end_reason") {
        trial.end_reason = end_reason(row, place);
      } else {
        (name == "algorithm"  ? trial.algorithm
         : name == "lighting" ? trial.lighting
         : name == "day"      ? trial.day
                              : trial.batch) = cell;
      }
    }
  }

 private:
  [[nodiscard]] EndReason end_reason(std::size_t row, std::size_t column) const {
    const std::string word = table::case_folded(table_.at(row, column));
    for (const EndReason reason : {EndReason::goal,
                                   EndReason::collision,
                                   EndReason::wedged,
                                   EndReason::timeout,
                                   EndReason::aborted}) {
      if (to_string(reason) == word) {
        return reason;
      }
    }
    if (!table::is_missing_cell(table_.at(row, column))) {
      add(Severity::warning,
          row,
          column,
          "goal, collision, wedged, timeout or aborted; it is left unknown");
    }
    return EndReason::unknown;
  }

  const table::TextTable& table_;
  std::string file_;
  table::DiagnosticGroups& problems_;
};

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
