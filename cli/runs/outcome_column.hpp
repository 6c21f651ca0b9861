#pragma once
/// \file
/// --success: the column of the outcome and the words in it that count as a success.

#include <span>
#include <string>
#include <table/data_table.hpp>
#include <vector>

#include "cli/runs/progress.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert::cli {

struct OutcomeColumn {
  std::string column;
  std::vector<std::string> words;  ///< Empty: by outcome_of_cell().
};

/// "success", or "status=goal,done". \throws UsageError if a part is empty.
[[nodiscard]] OutcomeColumn outcome_column(const std::string& option);

/// What the texts of an outcome were taken for; both empty if it was one of 0 and 1.
struct OutcomeTexts {
  std::string column;
  std::string success;  ///< Comma between.
  std::string failure;
};

/// Makes the column one of 0 and 1. \throws FormulaError that names the cell and the way out.
[[nodiscard]] OutcomeTexts code_outcome_column(const OutcomeColumn& outcome,
                                               table::DataTable& table);

/// Says which texts count as what, also in the report as a note and the settings
/// event_level and reference_level, as `fit` has them. Nothing of an outcome of 0 and 1.
void name_outcome_texts(const OutcomeTexts& texts, FitReport& report, Progress& progress);

/// \throws FormulaError if one of these columns holds numbers or truth values and words for missing
/// cells (N/A, null): each would be a group or a cluster of its own.
void refuse_missing_words(std::span<const std::string> columns, const table::DataTable& table);

}  // namespace tcert::cli
