#include <algorithm>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/frame_checks.hpp>
#include <statistics/model/frame_parts.hpp>
#include <statistics/model/outcome_coding.hpp>
#include <statistics/model/stray_text.hpp>
#include <table/cell_reading.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

std::string missing_word_of(const table::Factor& factor) {
  const auto found =
      std::find_if(factor.levels.begin(), factor.levels.end(), [](const std::string& level) {
        return table::read_cell(level).meaning == table::CellMeaning::missing_word;
      });
  return found == factor.levels.end() ? "" : *found;
}

void refuse_bad_outcome(const NamedVariable& outcome,
                        const table::DataTable& table,
                        const table::DataColumn* column) {
  const auto& levels = outcome.value.factor.levels;
  const std::string name = to_string(outcome.expression);
  if (column != nullptr && column->mixed.is_spoiled()) {
    throw FormulaError(stray_cell(table, *column));
  }
  if (column != nullptr && column->mixed.missing_words > 0) {
    throw FormulaError("'" + name + "' of " + table.file + " holds '" +
                       missing_word_of(outcome.value.factor) + "', which is no outcome; " +
                       std::string(table::kHowMissingIsWritten));
  }
  if (levels.size() == 1 || levels.size() > 2) {
    throw FormulaError("'" + name + "' has " + std::to_string(levels.size()) +
                       (levels.size() == 1 ? " level" : " levels") +
                       "; an outcome has two: write " + name + " == \"" + levels.back() + "\"");
  }
}

/// A factor of two levels as 0 and 1: by the levels of the whole column, so that the rows that
/// happen to be complete do not turn it over.
/// Words that everybody writes for an outcome mean what they say, whatever their order.
std::vector<double> outcome_numbers(const EvaluatedFormula& all,
                                    const NamedVariable& outcome,
                                    ModelFrame& frame) {
  if (outcome.value.kind != Variable::Kind::factor) {
    return on_rows(outcome.value.numbers, frame.rows);
  }
  const table::Factor& factor = outcome.value.factor;
  const table::DataColumn* const column = text_column(outcome.expression, all.table);
  const bool has_order = column == nullptr || all.options.reference.contains(column->name);
  if (const auto coding = has_order ? std::nullopt : coded_by_words(factor)) {
    if (!coding->failure.empty() && !coding->success.empty()) {
      frame.outcome_levels = {coding->failure, coding->success};
    }
    return on_rows(coding->values, frame.rows);
  }
  refuse_bad_outcome(outcome, all.table, column);
  std::vector<double> codes;
  codes.reserve(frame.rows.size());
  for (const std::size_t row : frame.rows) {
    codes.push_back(factor.codes[row]);
  }
  frame.outcome_levels = on_rows(factor, frame.rows).levels;
  return codes;
}

void take_survival(const EvaluatedFormula& all, ModelFrame& frame) {
  const std::size_t arguments = all.outcome.size();
  if (arguments != 2 && arguments != 3) {
    throw FormulaError("'" + frame.response + "': Surv(time, event) or Surv(start, stop, event)");
  }
  SurvivalOutcome survival;
  const NamedVariable& time = all.outcome[arguments - 2];
  const NamedVariable& status = all.outcome.back();
  const std::string time_name = to_string(time.expression);
  survival.stop = on_rows(time.value.numbers, frame.rows);
  if (arguments == 3) {
    survival.start = on_rows(all.outcome.front().value.numbers, frame.rows);
  }
  const std::vector<double> events = outcome_numbers(all, status, frame);
  check_binary(events, to_string(status.expression), frame);
  survival.event.reserve(events.size());
  for (const double event : events) {
    survival.event.push_back(event == 1.0 ? 1 : 0);
  }
  check_times(survival, time_name, frame);
  if (!has_error(frame.conditions)) {
    round_and_check_times(survival, time_name, all.options.round_times, frame);
  }
  frame.outcome = std::move(survival);
}

void take_counts(const EvaluatedFormula& all, ModelFrame& frame) {
  if (all.outcome.size() != 2) {
    throw FormulaError("'" + frame.response + "': cbind(successes, failures)");
  }
  CountOutcome counts{on_rows(all.outcome[0].value.numbers, frame.rows),
                      on_rows(all.outcome[1].value.numbers, frame.rows)};
  for (std::size_t i = 0; i < counts.trials.size(); ++i) {
    counts.trials[i] += counts.successes[i];
  }
  frame.outcome = std::move(counts);
  check_counts(frame);
}

}  // namespace

void take_outcome(const EvaluatedFormula& all, ModelFrame& frame) {
  if (all.formula.response.is_call("Surv")) {
    take_survival(all, frame);
  } else if (all.formula.response.is_call("cbind")) {
    take_counts(all, frame);
  } else {
    NumberOutcome numbers{outcome_numbers(all, all.outcome.front(), frame)};
    check_finite(numbers.values, frame.response, frame);
    frame.outcome = std::move(numbers);
  }
}

}  // namespace tcert::statistics
