#pragma once
// Columns and numbers of the golden files.

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <table/csv.hpp>
#include <vector>

namespace tcert::statistics {

/// One numeric column of a CSV file; NA is NaN. Empty if the file has no such column.
inline std::vector<double> read_column(const std::filesystem::path& path, const std::string& name) {
  const table::TextTableResult file = table::read_text_table(path, {name});
  std::vector<double> values;
  if (!file.table) {
    return values;
  }
  const std::size_t column = file.table->find(name).value();
  for (std::size_t row = 0; row < file.table->rows(); ++row) {
    const std::string& cell = file.table->at(row, column);
    values.push_back(cell == "NA" ? std::numeric_limits<double>::quiet_NaN() : std::stod(cell));
  }
  return values;
}

/// A number as the golden files write it: "Inf", "-Inf" and "NA" are strings.
inline double number(const nlohmann::json& value) {
  if (value.is_number()) {
    return value.get<double>();
  }
  if (value == "Inf") {
    return std::numeric_limits<double>::infinity();
  }
  if (value == "-Inf") {
    return -std::numeric_limits<double>::infinity();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tcert::statistics
