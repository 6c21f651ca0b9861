#include "cli/runs/outcome_column.hpp"

#include <algorithm>
#include <statistics/model/expression.hpp>
#include <statistics/model/outcome_coding.hpp>
#include <statistics/model/stray_text.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"

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

OutcomeTexts code_outcome_column(const OutcomeColumn& outcome, table::DataTable& table) {
  statistics::OutcomeCoding coding;
  try {
    coding = statistics::code_outcome(table, outcome.column, outcome.words);
  } catch (const statistics::FormulaError& error) {
    const bool is_there = table.find(outcome.column) != nullptr;
    throw statistics::FormulaError(std::string(error.what()) +
                                   (is_there && outcome.words.empty()
                                        ? "; --success '" + outcome.column +
                                              "=WORD[,WORD]' names the words that count as success"
                                        : ""));
  }
  const auto column =
      std::find_if(table.columns.begin(), table.columns.end(), [&](const table::DataColumn& one) {
        return one.name == outcome.column;
      });
  *column = {outcome.column, false, std::move(coding.values), {}, false, {}};
  return {outcome.column, std::move(coding.success), std::move(coding.failure)};
}

void name_outcome_texts(const OutcomeTexts& texts, FitReport& report, Progress& progress) {
  if (texts.success.empty() && texts.failure.empty()) {
    return;
  }
  const auto quoted = [](const std::string& words) {
    return words.empty() ? std::string("nothing") : "'" + words + "'";
  };
  std::string detail = quoted(texts.success) + " counts as 1, " + quoted(texts.failure) + " as 0";
  progress.say("tcert hypotheses: note: column '" + texts.column + "': " + detail);
  report.settings.emplace_back("event_level", texts.success);
  report.settings.emplace_back("reference_level", texts.failure);
  report.conditions.push_back({statistics::ConditionKind::text_outcome,
                               statistics::ConditionSeverity::note,
                               texts.column,
                               std::move(detail)});
}

void refuse_missing_words(std::span<const std::string> columns, const table::DataTable& table) {
  for (const std::string& name : columns) {
    tcert::statistics::refuse_missing_words(table, table.find(name));
  }
}

}  // namespace tcert::cli
