#pragma once
/// \file
/// Texts in columns of numbers, as a refusal names them.

#include <string>
#include <table/data_table.hpp>

namespace tcert::statistics {

/// "'N/A' in row 3 of column x of t.csv (line 4; 6 such cells beside 24 numbers) is not a number; a
/// missing cell is empty, NA or nan": the first cell that keeps a text column from being one of
/// numbers, or of truth values if it has no numbers. \pre the column is text and holds numbers or
/// truth values, and something else.
[[nodiscard]] std::string stray_cell(const table::DataTable& table,
                                     const table::DataColumn& column);

/// "'x' of t.csv holds text, not numbers", and its stray cell if it holds numbers too.
[[nodiscard]] std::string not_numbers(const table::DataTable& table, const std::string& column);

/// A word for a missing cell (N/A, null) among numbers or truth values would otherwise be a group,
/// a cluster or a cause of its own. \throws FormulaError with the stray cell if the column holds
/// one; a column that is not there has none.
void refuse_missing_words(const table::DataTable& table, const table::DataColumn* column);

}  // namespace tcert::statistics
