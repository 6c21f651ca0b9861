#include <statistics/model/stray_text.hpp>

#include <statistics/model/expression.hpp>
#include <table/cell_reading.hpp>
#include <table/diagnostic.hpp>

namespace tcert::statistics {

std::string stray_cell(const table::DataTable& table, const table::DataColumn& column) {
  const table::MixedCells& mixed = column.mixed;
  const bool of_numbers = mixed.numbers > 0;
  const std::size_t strays =
      mixed.texts + mixed.missing_words + (of_numbers ? mixed.truths : std::size_t{0});
  std::string text = "'" +
                     table::shortened(column.text.levels[column.text.codes[mixed.first_row]]) +
                     "' in row " + std::to_string(mixed.first_row + 1) + " of column " +
                     column.name + " of " + table.file + " (";
  if (mixed.first_row < table.lines.size()) {
    text += "line " + std::to_string(table.lines[mixed.first_row]) + "; ";
  }
  text += std::to_string(strays) + (strays == 1 ? " such cell" : " such cells") + " beside " +
          std::to_string(of_numbers ? mixed.numbers : mixed.truths) +
          (of_numbers ? " numbers) is not a number; " : " truth values) is not TRUE or FALSE; ");
  return text.append(table::kHowMissingIsWritten);
}

std::string not_numbers(const table::DataTable& table, const std::string& column) {
  std::string text = "'" + column + "' of " + table.file + " holds text, not numbers";
  const table::DataColumn* const data = table.find(column);
  const bool is_mixed = data != nullptr && data->is_text &&
                        (data->mixed.numbers > 0 || data->mixed.has_missing_words());
  return is_mixed ? text + ": " + stray_cell(table, *data) : text;
}

void refuse_missing_words(const table::DataTable& table, const table::DataColumn* column) {
  if (column != nullptr && column->is_text && column->mixed.has_missing_words()) {
    throw FormulaError(stray_cell(table, *column));
  }
}

}  // namespace tcert::statistics
