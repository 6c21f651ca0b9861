#include "analysis/study/trials/table_columns.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/model/stray_text.hpp>
#include <statistics/model/variable.hpp>
#include <table/csv_write.hpp>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::study {

std::vector<double> numbers_in(const table::DataTable& table, const std::string& column) {
  statistics::Variable variable =
      statistics::evaluate({statistics::Expression::Kind::column, 0.0, column, {}}, table);
  if (variable.kind == statistics::Variable::Kind::factor) {
    throw statistics::FormulaError("column " + statistics::not_numbers(table, column));
  }
  return std::move(variable.numbers);
}

std::vector<std::string> words_in(const table::DataTable& table, const std::string& column) {
  const table::DataColumn* const found = table.find(column);
  if (found == nullptr || !found->is_text) {
    const std::vector<double> numbers = numbers_in(table, column);
    std::vector<std::string> words(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      table::append_number(words[i], numbers[i]);
    }
    return words;
  }
  std::vector<std::string> words(table.rows);
  for (std::size_t i = 0; i < table.rows; ++i) {
    if (found->text.codes[i] != table::Factor::kMissing) {
      words[i] = found->text.levels[found->text.codes[i]];
    }
  }
  return words;
}

bool is_there(const table::DataTable& table, const std::string& name) {
  const table::DataColumn* const column = table.find(name);
  return column != nullptr &&
         (column->is_text ? !column->text.levels.empty()
                          : std::any_of(column->numbers.begin(),
                                        column->numbers.end(),
                                        [](double x) { return !std::isnan(x); }));
}

std::vector<double> numbers_if_there(const table::DataTable& table, const std::string& column) {
  return table.find(column) == nullptr ? std::vector<double>(table.rows, table::kNaN)
                                       : numbers_in(table, column);
}

}  // namespace tcert::study
