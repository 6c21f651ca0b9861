#pragma once
/// \file
/// A CSV file as typed columns: numbers, or names as a factor. What every model is fitted to.

#include <cstddef>
#include <string>
#include <string_view>
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
  std::size_t learned = 0;  ///< What is learned of a column, as its mean for scale(), comes of so
                            ///< many rows; 0 for all of them.

  /// Null if there is no such column.
  [[nodiscard]] const DataColumn* find(std::string_view name) const noexcept;
};

}  // namespace tcert::table
