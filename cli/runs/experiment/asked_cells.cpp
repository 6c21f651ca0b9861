#include "cli/runs/experiment/asked_cells.hpp"

#include <stdexcept>
#include <table/csv_write.hpp>

#include "analysis/study/experiment/paper_cells.hpp"
#include "cli/runs/data_file.hpp"

namespace tcert::cli {
namespace {

std::vector<study::GridAxis> axes_of(const std::vector<std::string>& texts) {
  std::vector<study::GridAxis> axes;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    const std::vector<std::string> values = equals == std::string::npos
                                                ? std::vector<std::string>{}
                                                : words_of(text.substr(equals + 1));
    if (equals == 0 || values.empty()) {
      throw UsageError("--grid: found '" + text + "', expected KEY=V1,V2,...");
    }
    axes.push_back({text.substr(0, equals), values});
  }
  return axes;
}

}  // namespace

std::vector<study::Cell> cells_of_file(const CellsRequest& options, Progress& progress) {
  const DataFile file = read_data_file(options.cells, {}, options.logs.decimal_comma, progress);
  std::vector<study::Cell> cells(file.table.rows);
  for (std::size_t row = 0; row < cells.size(); ++row) {
    cells[row].name = "row " + std::to_string(row + 1);
  }
  for (const table::DataColumn& column : file.table.columns) {
    for (std::size_t row = 0; row < cells.size(); ++row) {
      std::string value;
      if (!column.is_text) {
        table::append_number(value, column.numbers[row]);
      } else if (column.text.codes[row] != table::Factor::kMissing) {
        value = column.text.levels[column.text.codes[row]];
      }
      const bool missing = value.empty() || value == "nan";
      if (column.name == "cell" && !missing) {
        cells[row].name = value;
      } else if (!missing) {
        cells[row].overrides.emplace_back(column.name, value);
      }
    }
  }
  return cells;
}

std::vector<study::Cell> cells_of_grid(const std::vector<std::string>& texts) {
  try {
    return study::grid_cells(axes_of(texts));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace tcert::cli
