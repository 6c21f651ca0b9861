#include "analysis/study/h1/panel_times.hpp"

#include <algorithm>
#include <statistics/model/expression.hpp>
#include <statistics/survival/failures_at_limit.hpp>
#include <statistics/survival/time_conditions.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <string>
#include <table/csv_write.hpp>
#include <utility>

namespace tcert::study {
namespace {

/// "found 0 in row 8 (and 1 more)": of the times that are not above `earliest`; empty if all are.
std::string bad_times(const std::vector<double>& time,
                      const std::vector<std::size_t>& rows,
                      double earliest,
                      const H1Options& options) {
  std::string found;
  std::size_t bad = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (is_by(earliest, time[i], options) && bad++ == 0) {
      found = "found ";
      table::append_number(found, time[i]);
      found += " in row " + std::to_string(rows[i] + 1);
    }
  }
  return bad > 1 ? found + " (and " + std::to_string(bad - 1) + " more)" : found;
}

/// A trial that runs longer than the limit is cut there, without event.
void end_at_limit(const H1Options& options,
                  double earliest,
                  statistics::SurvivalOutcome& outcome,
                  H1Panel& panel,
                  H1Data& data) {
  data.cut.assign(outcome.rows(), 0);
  if (!options.limit_s) {
    return;
  }
  if (is_by(earliest, *options.limit_s, options)) {
    throw statistics::FormulaError("the trial limit lies before the times begin");
  }
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < outcome.rows(); ++i) {
    if (is_same(outcome.stop[i], *options.limit_s, options)) {
      outcome.stop[i] = *options.limit_s;
    } else if (outcome.stop[i] > *options.limit_s) {
      outcome.stop[i] = *options.limit_s;
      outcome.event[i] = 0;
      data.cut[i] = 1;
      ++beyond;
    }
  }
  if (beyond > 0) {
    panel.conditions.push_back({statistics::ConditionKind::beyond_limit,
                                statistics::ConditionSeverity::note,
                                options.time,
                                std::to_string(beyond) + " of " + std::to_string(outcome.rows())});
  }
}

}  // namespace

bool is_same(double at, double time, const H1Options& options) {
  return time == at || (options.round_times && statistics::same_time(at, time));
}

bool is_by(double at, double time, const H1Options& options) {
  return time <= at || is_same(at, time, options);
}

void add_times(const std::vector<double>& time,
               const std::vector<std::size_t>& rows,
               const H1Options& options,
               H1Panel& panel,
               H1Data& data) {
  statistics::SurvivalOutcome outcome;
  outcome.stop = time;
  outcome.event = data.success;
  const bool landmark = panel.kind == H1PanelKind::landmark;
  if (landmark) {
    outcome.start.assign(time.size(), options.landmark_s);
  }
  const double earliest = landmark ? options.landmark_s : 0.0;
  if (const std::string bad = bad_times(time, rows, earliest, options); !bad.empty()) {
    panel.conditions.push_back({statistics::ConditionKind::time_not_positive,
                                statistics::ConditionSeverity::warning,
                                options.time,
                                bad + "; no times are used"});
    panel.has_time = false;
    return;
  }
  statistics::add_unlike_times(
      time,
      options.time,
      [&](std::size_t i) { return "row " + std::to_string(rows[i] + 1); },
      panel.conditions);
  const bool is_far = statistics::has(panel.conditions, statistics::ConditionKind::unlike_times);
  end_at_limit(options, earliest, outcome, panel, data);
  statistics::add_rounding_conditions(
      options.round_times ? statistics::round_times(outcome) : statistics::count_times(outcome),
      options.time,
      panel.conditions);
  const double longest =
      time.empty() ? 0.0 : *std::max_element(outcome.stop.begin(), outcome.stop.end());
  panel.limit_s = options.limit_s.value_or(longest);
  if (is_far && !options.limit_s) {
    std::string detail = "failures stay at risk to ";
    table::append_number(detail, longest);
    panel.conditions.push_back({statistics::ConditionKind::limit_from_data,
                                statistics::ConditionSeverity::warning,
                                options.time,
                                std::move(detail)});
  }
  std::vector<std::uint8_t> failed(data.success.size());
  std::transform(data.success.begin(), data.success.end(), failed.begin(), [](std::uint8_t s) {
    return static_cast<std::uint8_t>(s == 0 ? 1 : 0);
  });
  data.at_limit = statistics::failures_at_limit(outcome, failed, panel.limit_s);
  data.censored = std::move(outcome);
}

}  // namespace tcert::study
