#include "cli/outcome_column.hpp"

#include <algorithm>

#include "analysis/model/expression.hpp"
#include "analysis/model/outcome_coding.hpp"
#include "analysis/model/stray_text.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/output.hpp"

namespace tcert::cli {

OutcomeColumn outcome_column(const std::string& option) {
  const std::size_t equals = option.find('=');
  OutcomeColumn outcome{option.substr(0, equals), {}};
  if (equals != std::string::npos) {
    outcome.words = words_of(option.substr(equals + 1));
  }
  if (outcome.column.empty() || (equals != std::string::npos && outcome.words.empty())) {
    throw UsageError("--success: found '" + option + "', expected COLUMN or COLUMN=WORD[,WORD]");
  }
  return outcome;
}

void code_outcome_column(const OutcomeColumn& outcome, DataTable& table) {
  OutcomeCoding coding;
  try {
    coding = code_outcome(table, outcome.column, outcome.words);
  } catch (const FormulaError& error) {
    const bool is_there = table.find(outcome.column) != nullptr;
    throw FormulaError(std::string(error.what()) +
                       (is_there && outcome.words.empty()
                            ? "; --success '" + outcome.column +
                                  "=WORD[,WORD]' names the words that count as success"
                            : ""));
  }
  if (!coding.success.empty() || !coding.failure.empty()) {
    say("tcert hypotheses: note: column '" + outcome.column + "': " +
        (coding.success.empty() ? "nothing" : "'" + coding.success + "'") + " counts as 1, " +
        (coding.failure.empty() ? "nothing" : "'" + coding.failure + "'") + " as 0");
  }
  const auto column =
      std::find_if(table.columns.begin(), table.columns.end(), [&](const DataColumn& one) {
        return one.name == outcome.column;
      });
  *column = {outcome.column, false, std::move(coding.values), {}, false, {}};
}

void refuse_missing_words(std::span<const std::string> columns, const DataTable& table) {
  for (const std::string& name : columns) {
    tcert::refuse_missing_words(table, table.find(name));
  }
}

}  // namespace tcert::cli
