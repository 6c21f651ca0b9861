#include "datasets/import/outcome_cells.hpp"

#include <algorithm>
#include <cmath>
#include <table/cell_reading.hpp>
#include <table/nearest_name.hpp>
#include <table/outcome_word.hpp>
#include <utility>

#include "datasets/trial_table.hpp"

namespace tcert::recording {

using table::Severity;

Outcomes::Outcomes(const table::TextTable& table,
                   std::string file,
                   table::DiagnosticGroups& problems)
    : table_(table), file_(std::move(file)), problems_(problems) {}

std::optional<std::size_t> Outcomes::column(const std::string& name) const {
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

void Outcomes::add(Severity severity,
                   std::size_t row,
                   std::size_t column,
                   std::string expectation) const {
  problems_.add({severity,
                 file_,
                 table_.lines[row],
                 table_.columns[column],
                 table::shortened(table_.at(row, column)),
                 std::move(expectation),
                 1});
}

std::optional<bool> Outcomes::success(std::size_t row,
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

std::optional<double> Outcomes::number(std::size_t row, std::size_t column, double scale) const {
  const auto reading = table::read_cell(table_.at(row, column), table_.dialect.decimal_point);
  if (reading.meaning == table::CellMeaning::number && std::isfinite(reading.value)) {
    return reading.value * scale;
  }
  if (reading.meaning != table::CellMeaning::missing) {
    add(Severity::error, row, column, "a number");
  }
  return std::nullopt;
}

void Outcomes::fill(std::size_t row,
                    const std::vector<OutcomeSource>& sources,
                    TrialRow& trial) const {
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

EndReason Outcomes::end_reason(std::size_t row, std::size_t column) const {
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

}  // namespace tcert::recording
