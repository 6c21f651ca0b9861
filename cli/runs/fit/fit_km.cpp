#include <array>

#include <statistics/model/factor_levels.hpp>
#include <statistics/model/stray_text.hpp>
#include <statistics/model/variable.hpp>
#include <statistics/survival/cumulative_incidence.hpp>
#include <statistics/survival/log_rank.hpp>
#include <statistics/survival/survival_curve.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/survival_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::array kScales{statistics::IntervalScale::log,
                             statistics::IntervalScale::log_log,
                             statistics::IntervalScale::plain,
                             statistics::IntervalScale::logit,
                             statistics::IntervalScale::arcsin};

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
  keep(rows, survival.start);
  keep(rows, survival.stop);
  keep(rows, survival.event);
  keep(rows, frame.rows);
  keep(rows, frame.lines);
  for (std::optional<table::Factor>* const factor :
       {&frame.groups, &frame.strata, &frame.cluster}) {
    if (*factor) {
      *factor = statistics::on_rows(**factor, rows);
    }
  }
  if (frame.weights) {
    Eigen::VectorXd weights(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      weights[static_cast<Eigen::Index>(i)] = (*frame.weights)[static_cast<Eigen::Index>(rows[i])];
    }
    frame.weights = std::move(weights);
  }
}

/// The cause of each row, 0 if it is censored. Events without a cause are no censored rows: they
/// leave the frame, counted.
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

}  // namespace

FitReport fit_km(const FitInput& from) {
  const auto* const survival = std::get_if<statistics::SurvivalOutcome>(&from.frame.outcome);
  if (survival == nullptr) {
    throw statistics::FormulaError("'" + from.frame.response +
                                   "': a survival curve needs Surv(time, event)");
  }
  statistics::Conditions conditions;
  std::optional<statistics::CompetingOutcome> competing;
  if (!from.request.cause.empty()) {
    competing = competing_outcome(from, conditions);
  }
  const statistics::ModelFrame& frame = from.frame;
  const bool by_strata = frame.terms.empty() && frame.strata;
  const table::Factor* const groups = by_strata ? &*frame.strata : &*frame.groups;
  const table::Factor* const cluster = frame.cluster ? &*frame.cluster : nullptr;
  std::span<const double> weights;
  if (frame.weights) {
    weights = {frame.weights->data(), static_cast<std::size_t>(frame.weights->size())};
  }
  SurvivalReportOptions shown;
  shown.scale = kScales[choice(
      "interval", from.request.interval, {"log", "log-log", "plain", "logit", "arcsin"})];
  shown.level = from.request.level;
  shown.times = numbers_of("times", from.request.times);

  statistics::CurveOptions curve_options;
  curve_options.weights = weights;
  curve_options.groups = groups;
  curve_options.cluster = cluster;
  std::optional<statistics::LogRankTest> test;
  if (!frame.terms.empty() && frame.weights) {
    conditions.push_back(
        {statistics::ConditionKind::no_weighted_test, statistics::ConditionSeverity::note, "", ""});
  } else if (!frame.terms.empty()) {
    test = statistics::log_rank_test(
        *survival, *groups, frame.strata ? &*frame.strata : nullptr, from.request.rho);
  }
  FitReport report =
      survival_report(statistics::survival_curves(*survival, curve_options), test, shown);
  report.conditions.insert(report.conditions.end(), conditions.begin(), conditions.end());
  if (competing) {
    statistics::IncidenceOptions incidence;
    incidence.weights = weights;
    incidence.groups = groups;
    incidence.cluster = cluster;
    add_incidence(
        statistics::cumulative_incidence(std::move(*competing), incidence), shown, report);
  }
  return report;
}

}  // namespace tcert::cli
