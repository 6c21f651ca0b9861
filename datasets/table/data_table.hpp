#pragma once
/// \file
/// A CSV file as typed columns: numbers, or names as a factor. What every model is fitted to.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <table/bytes.hpp>
#include <table/csv_header.hpp>
#include <table/diagnostic.hpp>
#include <table/factor.hpp>
#include <table/mixed_cells.hpp>
#include <vector>

namespace tcert::table {

/// A column is numeric if every cell is a number, infinite or missing; or a truth value, alone or
/// beside nothing but 0 and 1. Otherwise it is text, and each distinct cell a level.
struct DataColumn {
  std::string name;
  bool is_text = false;
  std::vector<double> numbers;  ///< Of a numeric column; NaN where missing; infinities kept.
  Factor text;                  ///< Of a text column.
  bool is_truth = false;        ///< Numeric, and every cell that is not missing is a truth value.
  MixedCells mixed;             ///< Of a text column.
};

struct DataTable {
  std::string file;                 ///< Its name in messages.
  std::vector<std::string> header;  ///< All columns of the file.
  std::vector<DataColumn> columns;  ///< Those that were wanted, in the order of the file.
  std::size_t rows = 0;
  std::vector<std::size_t> lines;  ///< Of the file, one a row; empty if there is no file.

  /// Null if there is no such column.
  [[nodiscard]] const DataColumn* find(std::string_view name) const noexcept;
};

struct DataTableResult {
  std::optional<DataTable> table;  ///< Empty iff there is an error.
  std::vector<Diagnostic> diagnostics;
};

/// Reads the columns called `wanted`, all of them if it is empty; names that the file does not have
/// are not an error here. Cells are read by read_cell(). A row with another number of cells than
/// the header is an error; a text column that holds more numbers than texts, or is spoiled, a
/// warning. O(size).
[[nodiscard]] DataTableResult read_data_table(const std::filesystem::path& path,
                                              std::span<const std::string> wanted = {},
                                              CsvOptions csv = {});

/// The same from bytes; `csv.file` names them.
[[nodiscard]] DataTableResult read_data_table(const Bytes& bytes,
                                              std::span<const std::string> wanted,
                                              const CsvOptions& csv);

}  // namespace tcert::table
