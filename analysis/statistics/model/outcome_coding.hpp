#pragma once
/// \file
/// A column of outcomes as 0 and 1: by the words that everybody writes, or by those that are named.

#include <optional>
#include <string>
#include <table/data_table.hpp>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

struct OutcomeCoding {
  std::vector<double> values;  ///< One a row: 1 success, 0 failure, NaN missing.
  std::string failure;         ///< The texts that are 0, comma between; empty of a numeric column.
  std::string success;         ///< Those that are 1.
};

/// By outcome_of_cell(): "s" is 1 and "f" is 0 whatever their order. Empty if a level is not one
/// of its words. O(rows + levels).
[[nodiscard]] std::optional<OutcomeCoding> coded_by_words(const table::Factor& text);

/// The outcome in `column`: 0 and 1, truth values, or texts by outcome_of_cell(). If `success`
/// names words, these are 1 and every other one 0, numbers by value, truth values by any of their
/// spellings. \throws FormulaError that names the row, its line and what was found: for a value
/// that is no outcome, a word for a missing cell among texts, a word that the column does not hold,
/// or a column that is not there. O(rows).
[[nodiscard]] OutcomeCoding code_outcome(const table::DataTable& table,
                                         const std::string& column,
                                         const std::vector<std::string>& success = {});

}  // namespace tcert::statistics
