#include "analysis/study/h1/panel_columns.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/variable.hpp>
#include <utility>

#include "analysis/study/trials/table_columns.hpp"

namespace tcert::study {
namespace {

statistics::Expression column_named(const std::string& name) {
  return {statistics::Expression::Kind::column, 0.0, name, {}};
}

std::vector<double> finite_numbers(const table::DataTable& table, const std::string& column) {
  std::vector<double> values = numbers_if_there(table, column);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isinf(values[row])) {
      throw statistics::FormulaError(
          "column '" + column + "' of " + table.file + ", row " + std::to_string(row + 1) +
          ": found " + (values[row] > 0.0 ? "" : "-") + "Inf; make the cell NA or correct it");
    }
  }
  return values;
}

std::vector<double> outcome(const table::DataTable& table, const std::string& column) {
  std::vector<double> success = numbers_in(table, column);
  for (std::size_t row = 0; row < success.size(); ++row) {
    if (!std::isnan(success[row]) && success[row] != 0.0 && success[row] != 1.0) {
      throw statistics::FormulaError("column '" + column + "' of " + table.file + ", row " +
                                     std::to_string(row + 1) + ": an outcome is 0 or 1");
    }
  }
  return success;
}

}  // namespace

const std::string& column_of(const table::DataTable& table,
                             const H1Predictor& predictor,
                             H1PanelKind kind) {
  const bool landmark =
      kind == H1PanelKind::landmark && table.find(predictor.landmark_column) != nullptr;
  return landmark ? predictor.landmark_column : predictor.column;
}

std::optional<table::Factor> strata_of(const table::DataTable& table,
                                       const std::vector<std::string>& within,
                                       std::vector<std::string>& used) {
  std::vector<table::Factor> factors;
  for (const std::string& name : within) {
    if (is_there(table, name)) {
      factors.push_back(statistics::evaluate_factor(column_named(name), table));
      used.push_back(name);
    }
  }
  return factors.empty() ? std::nullopt : std::optional(statistics::crossed(factors, ", "));
}

PanelColumns columns_of_table(const table::DataTable& table,
                              const H1Options& options,
                              H1PanelKind kind) {
  PanelColumns columns;
  columns.success = outcome(table, options.success);
  columns.time = finite_numbers(table, options.time);
  columns.log_end = finite_numbers(table, "end_s");
  columns.end = columns.time;
  for (std::size_t row = 0; row < table.rows; ++row) {
    columns.end[row] = std::isnan(columns.end[row]) ? columns.log_end[row] : columns.end[row];
  }
  for (const H1Predictor& predictor : options.predictors) {
    static_cast<void>(numbers_in(table, predictor.column));  // both panels need it to be there
    columns.predictors.push_back(finite_numbers(table, column_of(table, predictor, kind)));
  }
  if (is_there(table, options.cluster)) {
    columns.cluster = statistics::evaluate_factor(column_named(options.cluster), table);
  }
  if (is_there(table, options.strata)) {
    columns.strata = statistics::evaluate_factor(column_named(options.strata), table);
  }
  if (!options.group.empty()) {
    columns.group = statistics::evaluate_factor(column_named(options.group), table);
  }
  return columns;
}

}  // namespace tcert::study
