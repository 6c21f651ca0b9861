#include "datasets/measured_cells.hpp"

#include <charconv>
#include <cmath>
#include <table/cell_reading.hpp>
#include <utility>

namespace tcert {

SyntheticTable synthetic_table(const table::TextTable& rows) {
  const auto column = rows.find("synthetic_seed");
  SyntheticTable result;
  result.synthetic = column.has_value() && rows.rows() > 0;
  if (result.synthetic) {
    const std::string& cell = rows.at(0, *column);
    std::uint64_t seed = 0;
    const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), seed);
    if (error == std::errc{} && stop == cell.data() + cell.size()) {
      result.seed = seed;
    }
  }
  return result;
}

std::optional<double> MeasuredCells::number(std::size_t row, std::size_t column) {
  const std::string& cell = rows_.at(row, column);
  const table::CellReading reading = table::read_cell(cell, rows_.dialect.decimal_point);
  if (reading.meaning == table::CellMeaning::number && std::isfinite(reading.value)) {
    return reading.value;
  }
  if (reading.meaning != table::CellMeaning::missing) {
    report(table::Severity::error,
           rows_.lines[row],
           rows_.columns[column],
           table::shortened(cell),
           "a finite number (" + std::string(table::kHowMissingIsWritten) + ")");
  }
  return std::nullopt;
}

void MeasuredCells::report(table::Severity severity,
                           std::size_t line,
                           std::string column,
                           std::string value,
                           std::string expectation) {
  problems_.add(
      {severity, file_, line, std::move(column), std::move(value), std::move(expectation), 1});
}

}  // namespace tcert
