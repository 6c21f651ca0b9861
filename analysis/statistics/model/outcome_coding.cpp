#include <statistics/model/outcome_coding.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <statistics/model/expression.hpp>
#include <statistics/model/variable.hpp>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/diagnostic.hpp>
#include <table/not_a_number.hpp>
#include <table/outcome_word.hpp>

namespace tcert::statistics {
namespace {

std::string column_of(const table::DataTable& table, const std::string& column) {
  return "column '" + column + "' of " + table.file;
}

[[noreturn]] void refuse(const table::DataTable& table,
                         const std::string& column,
                         std::size_t row,
                         const std::string& found,
                         const std::string& expectation) {
  std::string place = column_of(table, column) + ", row " + std::to_string(row + 1);
  if (row < table.lines.size()) {
    place += " (line " + std::to_string(table.lines[row]) + ")";
  }
  throw FormulaError(place + ": found '" + table::shortened(found) + "', expected " + expectation +
                     "; " + std::string(table::kHowMissingIsWritten));
}

void add_word(std::string& list, const std::string& word) {
  list += (list.empty() ? "" : ", ") + word;
}

/// The values of the rows from those of the levels; a level that is NaN is not to occur.
OutcomeCoding coding_of(const table::Factor& text, const std::vector<double>& value_of) {
  OutcomeCoding coding;
  coding.values.reserve(text.codes.size());
  for (const std::uint32_t code : text.codes) {
    coding.values.push_back(code == table::Factor::kMissing ? table::kNaN : value_of[code]);
  }
  for (std::size_t level = 0; level < value_of.size(); ++level) {
    add_word(value_of[level] == 1.0 ? coding.success : coding.failure, text.levels[level]);
  }
  return coding;
}

/// NaN for a level that is no outcome.
std::vector<double> values_by_words(const table::Factor& text) {
  std::vector<double> values;
  for (const std::string& level : text.levels) {
    const table::OutcomeWord word = table::outcome_of_cell(level);
    values.push_back(word == table::OutcomeWord::success   ? 1.0
                     : word == table::OutcomeWord::failure ? 0.0
                                                           : table::kNaN);
  }
  return values;
}

/// \throws FormulaError at the first row whose level has no value.
void require_values(const table::DataTable& table,
                    const table::DataColumn& column,
                    const std::vector<double>& value_of,
                    const std::string& expectation) {
  const auto& codes = column.text.codes;
  const auto bad = std::find_if(codes.begin(), codes.end(), [&](std::uint32_t code) {
    return code != table::Factor::kMissing && std::isnan(value_of[code]);
  });
  if (bad != codes.end()) {
    refuse(table,
           column.name,
           static_cast<std::size_t>(bad - codes.begin()),
           column.text.levels[*bad],
           expectation);
  }
}

[[noreturn]] void refuse_word(const table::DataTable& table,
                              const std::string& column,
                              const std::string& word,
                              const std::string& known) {
  throw FormulaError(column_of(table, column) + " holds no '" + word + "'" +
                     (known.empty() ? "" : ", only " + known));
}

OutcomeCoding texts_by_name(const table::DataTable& table,
                            const table::DataColumn& column,
                            const std::vector<std::string>& success) {
  constexpr std::size_t kMostListed = 12;
  const auto& levels = column.text.levels;
  std::string known;
  for (std::size_t level = 0; level < std::min(levels.size(), kMostListed); ++level) {
    add_word(known, levels[level]);
  }
  known += levels.size() > kMostListed ? ", ..." : "";
  std::vector<double> value_of(levels.size(), 0.0);
  for (const std::string& word : success) {
    const auto found = std::find(levels.begin(), levels.end(), word);
    if (found == levels.end()) {
      refuse_word(table, column.name, word, known);
    }
    value_of[static_cast<std::size_t>(found - levels.begin())] = 1.0;
  }
  std::vector<double> checked = value_of;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const bool is_missing_word =
        table::read_cell(levels[level]).meaning == table::CellMeaning::missing_word;
    checked[level] = is_missing_word && value_of[level] == 0.0 ? table::kNaN : value_of[level];
  }
  require_values(table, column, checked, "an outcome");
  return coding_of(column.text, value_of);
}

OutcomeCoding numbers_by_name(const table::DataTable& table,
                              const table::DataColumn& column,
                              const std::vector<std::string>& success) {
  OutcomeCoding coding;
  coding.values = column.numbers;
  std::vector<double> wanted;
  for (const std::string& word : success) {
    const table::CellReading reading = table::read_cell(word);
    const auto& x = column.numbers;
    if (std::isnan(reading.value) ||
        (reading.meaning == table::CellMeaning::truth) != column.is_truth ||
        std::find(x.begin(), x.end(), reading.value) == x.end()) {
      refuse_word(table, column.name, word, column.is_truth ? "TRUE and FALSE" : "");
    }
    wanted.push_back(reading.value);
  }
  for (double& x : coding.values) {
    const bool is_success = std::find(wanted.begin(), wanted.end(), x) != wanted.end();
    x = std::isnan(x) ? table::kNaN : is_success ? 1.0 : 0.0;
  }
  return coding;
}

}  // namespace

std::optional<OutcomeCoding> coded_by_words(const table::Factor& text) {
  const std::vector<double> value_of = values_by_words(text);
  if (std::any_of(value_of.begin(), value_of.end(), [](double x) { return std::isnan(x); })) {
    return std::nullopt;
  }
  return coding_of(text, value_of);
}

OutcomeCoding code_outcome(const table::DataTable& table,
                           const std::string& column,
                           const std::vector<std::string>& success) {
  const table::DataColumn& data = named_column(table, column);
  if (!success.empty()) {
    return data.is_text ? texts_by_name(table, data, success)
                        : numbers_by_name(table, data, success);
  }
  const std::string expectation = "an outcome: " + std::string(table::kOutcomeWords);
  if (data.is_text) {
    const std::vector<double> value_of = values_by_words(data.text);
    require_values(table, data, value_of, expectation);
    return coding_of(data.text, value_of);
  }
  for (std::size_t row = 0; row < table.rows; ++row) {
    const double x = data.numbers[row];
    if (!std::isnan(x) && x != 0.0 && x != 1.0) {
      refuse(table, column, row, table::number_text(x), expectation);
    }
  }
  return {data.numbers, "", ""};
}

}  // namespace tcert::statistics
