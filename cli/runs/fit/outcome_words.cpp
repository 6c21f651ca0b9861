#include "cli/runs/fit/outcome_words.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kSuccess = "log odds of success";

std::string outcome_in_words(const statistics::Formula& formula,
                             const statistics::ModelFrame& frame) {
  const statistics::Expression& response = formula.response;
  const std::string quoted = "'" + frame.response + "'";
  if (frame.outcome_levels.size() == 2) {
    return quoted + " = " + frame.outcome_levels[1] + " (against " + frame.outcome_levels[0] + ")";
  }
  if (response.is_call("cbind")) {
    return "a success in " + quoted;
  }
  return response.kind == statistics::Expression::Kind::column ? quoted + " = 1" : quoted;
}

}  // namespace

void name_outcome(const statistics::Formula& formula,
                  const statistics::ModelFrame& frame,
                  FitReport& report) {
  for (Table& table : report.tables) {
    const std::size_t at = table.title.find(kSuccess);
    if (at != std::string::npos) {
      table.title.replace(at, kSuccess.size(), "log odds of " + outcome_in_words(formula, frame));
    }
  }
  if (frame.outcome_levels.size() != 2) {
    return;
  }
  const std::string& zero = frame.outcome_levels[0];
  const std::string& one = frame.outcome_levels[1];
  report.settings.emplace_back("event_level", one);
  report.settings.emplace_back("reference_level", zero);
  report.conditions.push_back({statistics::ConditionKind::text_outcome,
                               statistics::ConditionSeverity::note,
                               frame.response,
                               "'" + one + "' counts as 1, '" + zero + "' as 0"});
}

}  // namespace tcert::cli
