#include <statistics/model/level_means.hpp>

#include <algorithm>
#include <set>
#include <statistics/model/new_rows.hpp>
#include <table/csv_write.hpp>

namespace tcert::statistics {
namespace {

/// The rows of the fit alone.
table::DataTable rows_of_fit(const table::DataTable& table, const std::vector<std::size_t>& rows) {
  table::DataTable own = table;
  own.rows = rows.size();
  own.lines.clear();
  for (table::DataColumn& column : own.columns) {
    const table::DataColumn& whole = *table.find(column.name);
    if (column.is_text) {
      column.text.codes.clear();
      for (const std::size_t row : rows) {
        column.text.codes.push_back(whole.text.codes[row]);
      }
    } else {
      column.numbers.clear();
      for (const std::size_t row : rows) {
        column.numbers.push_back(whole.numbers[row]);
      }
    }
  }
  return own;
}

std::string word_of(const table::DataColumn& column, double level) {
  if (column.is_text) {
    return column.text.levels[static_cast<std::size_t>(level)];
  }
  return column.is_truth ? level == 0.0 ? "FALSE" : "TRUE" : table::number_text(level);
}

/// Codes of a text, else numbers, each once.
std::vector<double> levels_of(const table::DataColumn& column) {
  std::set<double> found(column.numbers.begin(), column.numbers.end());
  for (const std::uint32_t code : column.text.codes) {
    found.insert(code);
  }
  return {found.begin(), found.end()};
}

}  // namespace

LevelMeans level_means(const Formula& formula,
                       const table::DataTable& table,
                       const ModelFrame& fitted,
                       const FrameOptions& options,
                       const std::string& column) {
  if (table.find(column) == nullptr) {
    throw FormulaError("there is no column '" + column + "' in the formula");
  }
  table::DataTable others = rows_of_fit(table, fitted.rows);
  const auto place = std::find_if(others.columns.begin(),
                                  others.columns.end(),
                                  [&](const auto& one) { return one.name == column; });
  const std::vector<double> levels = levels_of(*place);
  if (levels.size() < 2 || levels.size() > kMostComparedLevels) {
    throw FormulaError("column '" + column + "' has " + std::to_string(levels.size()) +
                       " levels in the rows of the fit; expected 2 to " +
                       std::to_string(kMostComparedLevels));
  }
  LevelMeans means;
  means.design.resize(static_cast<Eigen::Index>(levels.size()), fitted.design.cols());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    means.levels.push_back(word_of(*place, levels[k]));
    std::fill(place->numbers.begin(), place->numbers.end(), levels[k]);
    std::fill(
        place->text.codes.begin(), place->text.codes.end(), static_cast<std::uint32_t>(levels[k]));
    means.design.row(static_cast<Eigen::Index>(k)) =
        new_rows(formula, table, fitted, others, options).design.colwise().mean();
  }
  if ((means.design.rowwise() - means.design.row(0)).isZero(0.0)) {
    throw FormulaError("no term of the model has the column '" + column + "'");
  }
  return means;
}

}  // namespace tcert::statistics
