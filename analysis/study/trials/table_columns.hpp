#pragma once
/// \file
/// Columns of a table of trials or replays by name, as the hypotheses read them.

#include <string>
#include <table/data_table.hpp>
#include <vector>

namespace tcert::study {

/// The column's numbers. \throws FormulaError if it is not there or holds text.
[[nodiscard]] std::vector<double> numbers_in(const table::DataTable& table,
                                             const std::string& column);

/// The column's cells as they would be written, a number in its shortest form; empty where one is
/// missing. \throws FormulaError if it is not there.
[[nodiscard]] std::vector<std::string> words_in(const table::DataTable& table,
                                                const std::string& column);

/// A column without a single value is not there: feature tables have a column for all they could
/// know.
[[nodiscard]] bool is_there(const table::DataTable& table, const std::string& name);

/// All NaN if the table does not have it.
[[nodiscard]] std::vector<double> numbers_if_there(const table::DataTable& table,
                                                   const std::string& column);

}  // namespace tcert::study
