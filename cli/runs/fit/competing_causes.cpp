#include "cli/runs/fit/competing_causes.hpp"

#include <statistics/model/factor_levels.hpp>
#include <statistics/model/stray_text.hpp>
#include <statistics/model/variable.hpp>

namespace tcert::cli {
namespace {

template <class Value>
void keep(const std::vector<std::size_t>& rows, std::vector<Value>& values) {
  std::vector<Value> kept;
  for (const std::size_t row : rows) {
    if (!values.empty()) {
      kept.push_back(values[row]);
    }
  }
  values = std::move(kept);
}

/// Leaves only these rows of the frame.
void keep(const std::vector<std::size_t>& rows, statistics::ModelFrame& frame) {
  auto& survival = std::get<statistics::SurvivalOutcome>(frame.outcome);
  survival = statistics::on_rows(survival, rows);
  keep(rows, frame.rows);
  keep(rows, frame.lines);
  for (std::optional<table::Factor>* const factor :
       {&frame.groups, &frame.strata, &frame.cluster}) {
    if (*factor) {
      *factor = statistics::on_rows(**factor, rows);
    }
  }
  const std::vector<Eigen::Index> indices(rows.begin(), rows.end());
  frame.design = Eigen::MatrixXd(frame.design(indices, Eigen::all));
  for (std::optional<Eigen::VectorXd>* const vector : {&frame.weights, &frame.offset}) {
    if (*vector) {
      *vector = Eigen::VectorXd((**vector)(indices));
    }
  }
}

}  // namespace

statistics::CompetingOutcome competing_outcome(const FitInput& from,
                                               statistics::Conditions& conditions) {
  const std::string& column = from.request.cause;
  statistics::refuse_missing_words(from.table, from.table.find(column));
  const table::Factor all = statistics::evaluate_factor(
      {statistics::Expression::Kind::column, 0.0, column, {}}, from.table);
  statistics::ModelFrame& frame = from.frame;
  auto& survival = std::get<statistics::SurvivalOutcome>(frame.outcome);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < frame.size(); ++row) {
    if (survival.event[row] == 0 || all.codes[frame.rows[row]] != table::Factor::kMissing) {
      rows.push_back(row);
    }
  }
  const std::size_t left_out = frame.size() - rows.size();
  if (left_out > 0) {
    conditions.push_back({statistics::ConditionKind::missing_rows,
                          statistics::ConditionSeverity::warning,
                          column,
                          std::to_string(left_out) + " of " + std::to_string(frame.size()) +
                              " (events without a cause)"});
    frame.dropped += left_out;
    keep(rows, frame);
  }
  std::vector<std::uint32_t> number(all.levels.size(),
                                    0);  // of each level, from 1; 0 unless an event
  for (std::size_t row = 0; row < frame.size(); ++row) {
    if (survival.event[row] != 0) {
      number[all.codes[frame.rows[row]]] = 1;
    }
  }
  statistics::CompetingOutcome outcome;
  std::vector<bool> occurs(all.levels.size(), false);
  for (const std::size_t row : frame.rows) {
    if (all.codes[row] != table::Factor::kMissing) {
      occurs[all.codes[row]] = true;
    }
  }
  for (std::size_t level = 0; level < number.size(); ++level) {
    if (number[level] != 0) {
      outcome.causes.push_back(all.levels[level]);
      number[level] = static_cast<std::uint32_t>(outcome.causes.size());
    } else if (occurs[level]) {
      conditions.push_back({statistics::ConditionKind::no_such_event,
                            statistics::ConditionSeverity::note,
                            column,
                            "'" + all.levels[level] + "'"});
    }
  }
  outcome.start = survival.start;
  outcome.stop = survival.stop;
  for (std::size_t row = 0; row < frame.size(); ++row) {
    outcome.cause.push_back(survival.event[row] == 0 ? 0 : number[all.codes[frame.rows[row]]]);
  }
  return outcome;
}

}  // namespace tcert::cli
