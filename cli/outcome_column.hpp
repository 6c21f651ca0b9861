#pragma once
/// \file
/// --success: the column of the outcome and the words in it that count as a success.

#include <span>
#include <string>
#include <vector>

#include "datasets/data_table.hpp"

namespace tcert::cli {

struct OutcomeColumn {
  std::string column;
  std::vector<std::string> words;  ///< Empty: by outcome_of_cell().
};

/// "success", or "status=goal,done". \throws UsageError if a part is empty.
[[nodiscard]] OutcomeColumn outcome_column(const std::string& option);

/// Makes the column one of 0 and 1, and says which texts count as what. \throws FormulaError that
/// names the cell and the way out.
void code_outcome_column(const OutcomeColumn& outcome, DataTable& table);

/// \throws FormulaError if one of these columns holds numbers or truth values and words for missing
/// cells (N/A, null): each would be a group or a cluster of its own.
void refuse_missing_words(std::span<const std::string> columns, const DataTable& table);

}  // namespace tcert::cli
