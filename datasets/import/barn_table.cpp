#include "datasets/import/barn_table.hpp"

#include <charconv>
#include <cmath>
#include <table/cell_reading.hpp>
#include <utility>

namespace tcert {

bool BarnSource::require(const std::vector<std::string>& columns) const {
  bool all = true;
  for (const std::string& column : columns) {
    if (!has(column)) {
      problems_.add({table::Severity::error, file_, 0, column, "", "a column of this name", 1});
      all = false;
    }
  }
  return all;
}

void BarnSource::add(table::Severity severity,
                     std::size_t row,
                     std::string_view column,
                     std::string expectation) const {
  problems_.add({severity,
                 file_,
                 table_.lines[row],
                 std::string(column),
                 table::shortened(cell(row, column)),
                 std::move(expectation),
                 1});
}

std::optional<double> finite_number(std::string_view cell) {
  const table::CellReading reading = table::read_cell(cell);
  const bool is_number =
      reading.meaning == table::CellMeaning::number && std::isfinite(reading.value);
  return is_number ? std::optional(reading.value) : std::nullopt;
}

std::optional<long> barn_world(std::string_view cell) {
  long world = 0;
  const char* const end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, world);
  return error == std::errc{} && stop == end && world >= 0 ? std::optional(world) : std::nullopt;
}

}  // namespace tcert
