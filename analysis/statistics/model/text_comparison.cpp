#include <statistics/model/text_comparison.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <table/cell_reading.hpp>
#include <table/not_a_number.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

void refuse_other_missing_words(const Expression& call,
                                const table::Factor& factor,
                                const std::string& text,
                                const table::DataTable& table) {
  std::vector<bool> is_missing_word;
  for (const std::string& level : factor.levels) {
    is_missing_word.push_back(level != text &&
                              table::read_cell(level).meaning == table::CellMeaning::missing_word);
  }
  const auto found =
      std::find_if(factor.codes.begin(), factor.codes.end(), [&](std::uint32_t code) {
        return code != table::Factor::kMissing && is_missing_word[code];
      });
  if (found == factor.codes.end()) {
    return;
  }
  const auto row = static_cast<std::size_t>(found - factor.codes.begin());
  std::string place = "row " + std::to_string(row + 1) + " of " + table.file;
  if (row < table.lines.size()) {
    place += " (line " + std::to_string(table.lines[row]) + ")";
  }
  const std::string& word = factor.levels[*found];
  throw FormulaError("'" + to_string(call) + "': found '" + word + "' in " + place +
                     ", which would count as another text than '" + text + "'; " +
                     std::string(table::kHowMissingIsWritten) + "; if '" + word +
                     "' is a name, compare with it or call it something else");
}

}  // namespace

std::string truth_word(const std::string& word) {
  const table::CellReading reading = table::read_cell(word);
  return reading.meaning != table::CellMeaning::truth ? word
         : reading.value == 1.0                       ? "TRUE"
                                                      : "FALSE";
}

Variable compared_with_text(const Expression& call,
                            const table::Factor& factor,
                            const std::string& text,
                            const table::DataTable& table) {
  refuse_other_missing_words(call, factor, text, table);
  Variable result{Variable::Kind::truth, std::vector<double>(table.rows, table::kNaN), {}};
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (factor.codes[row] != table::Factor::kMissing) {
      const bool equal = factor.levels[factor.codes[row]] == text;
      result.numbers[row] = equal == (call.name == "==") ? 1.0 : 0.0;
    }
  }
  return result;
}

void require_known_word(const Expression& comparison, const table::DataTable& table) {
  const Expression& left = comparison.arguments[0];
  const Expression& right = comparison.arguments[1];
  if (left.kind != Expression::Kind::column || right.kind != Expression::Kind::column ||
      table.find(right.name) != nullptr) {
    return;
  }
  const table::DataColumn* const subject = table.find(left.name);
  if (subject == nullptr || !subject->is_text) {
    return;
  }
  const auto& levels = subject->text.levels;
  if (std::find(levels.begin(), levels.end(), right.name) != levels.end()) {
    throw FormulaError("no column '" + right.name + "' in " + table.file + "; for the text write " +
                       left.name + ' ' + comparison.name + " \"" + right.name + '"');
  }
}

}  // namespace tcert::statistics
