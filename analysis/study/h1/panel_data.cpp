#include "analysis/study/h1/panel_data.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/quantile.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/stray_text.hpp>
#include <statistics/model/variable.hpp>
#include <statistics/survival/failures_at_limit.hpp>
#include <statistics/survival/time_conditions.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <table/csv_write.hpp>
#include <table/nearest_name.hpp>

#include "analysis/study/h1/panel_columns.hpp"

namespace tcert::study {
namespace {

/// Whether two times are one: but for rounding, as `round_times` has it, unless every time is left
/// as it is.
bool is_same(double at, double time, const H1Options& options) {
  return time == at || (options.round_times && statistics::same_time(at, time));
}

/// Whether `time` is not after `at`.
bool is_by(double at, double time, const H1Options& options) {
  return time <= at || is_same(at, time, options);
}

std::vector<std::size_t> trials_of_panel(const table::DataTable& table,
                                         const H1Options& options,
                                         const PanelColumns& columns,
                                         H1Panel& panel) {
  const std::vector<double> still = numbers_if_there(table, "still_at_landmark");
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (std::isnan(columns.success[row])) {
      continue;
    }
    if (panel.kind == H1PanelKind::landmark) {
      if (is_by(options.landmark_s, columns.end[row], options) ||
          is_by(options.landmark_s, columns.log_end[row], options)) {
        ++panel.ended_by_landmark;
        continue;
      }
      if (still[row] == 1.0) {
        ++panel.still_at_landmark;
        continue;
      }
    }
    rows.push_back(row);
  }
  panel.trials = rows.size();
  const auto is_known = [](double end) { return !std::isnan(end); };
  panel.ends_known = std::any_of(columns.end.begin(), columns.end.end(), is_known);
  return rows;
}

void count_window_ends(const table::DataTable& table,
                       const H1Options& options,
                       const PanelColumns& columns,
                       H1Panel& panel) {
  if (panel.kind != H1PanelKind::paper || table.find("window_end_s") == nullptr) {
    return;
  }
  const std::vector<double> window_end = numbers_in(table, "window_end_s");
  std::size_t ended = 0;
  std::size_t failures = 0;
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (std::isnan(columns.success[row])) {
      continue;
    }
    const bool in_window = std::isnan(window_end[row])
                               ? !std::isnan(columns.log_end[row])
                               : is_by(window_end[row], columns.end[row], options);
    ended += in_window ? 1 : 0;
    failures += in_window && columns.success[row] == 0.0 ? 1 : 0;
  }
  panel.ended_in_window = ended;
  panel.failures_ended_in_window = failures;
}

/// Marks rows where `is_missing` holds and counts them.
template <class IsMissing>
std::size_t mark(const std::vector<std::size_t>& rows,
                 std::vector<bool>& complete,
                 const IsMissing& is_missing) {
  std::size_t missing = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_missing(rows[i])) {
      complete[i] = false;
      ++missing;
    }
  }
  return missing;
}

void list_missing(H1Panel& panel, const std::string& column, std::size_t missing) {
  if (missing > 0) {
    panel.missing.emplace_back(column, missing);
  }
}

std::vector<std::size_t> complete_trials(const std::vector<std::size_t>& rows,
                                         const H1Options& options,
                                         const PanelColumns& columns,
                                         H1Panel& panel) {
  std::vector<bool> complete(rows.size(), true);
  for (const std::vector<double>& predictor : columns.predictors) {
    panel.rows.emplace_back();
    panel.rows.back().missing =
        mark(rows, complete, [&](std::size_t row) { return std::isnan(predictor[row]); });
  }
  if (panel.has_time) {
    list_missing(panel, options.time, mark(rows, complete, [&](std::size_t row) {
                   return std::isnan(columns.time[row]);
                 }));
  }
  const auto mark_factor = [&](const std::optional<table::Factor>& factor,
                               const std::string& name) {
    if (factor) {
      list_missing(panel, name, mark(rows, complete, [&](std::size_t row) {
                     return factor->codes[row] == table::Factor::kMissing;
                   }));
    }
  };
  mark_factor(columns.cluster, options.cluster);
  mark_factor(columns.group, options.group);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (complete[i]) {
      kept.push_back(rows[i]);
    }
  }
  panel.complete = kept.size();
  return kept;
}

std::vector<double> on(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  std::vector<double> kept;
  kept.reserve(rows.size());
  for (const std::size_t row : rows) {
    kept.push_back(column[row]);
  }
  return kept;
}

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

TcDistribution distribution(const std::vector<std::size_t>& trials,
                            const PanelColumns& columns,
                            bool success) {
  TcDistribution result;
  result.success = success;
  std::vector<double> values;
  for (const std::size_t row : trials) {
    if ((columns.success[row] == 1.0) != success) {
      continue;
    }
    ++result.trials;
    if (const double value = columns.predictors[0][row]; !std::isnan(value)) {
      values.push_back(value);
    }
  }
  result.missing = result.trials - values.size();
  result.negative = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return value < 0.0; }));
  result.p10 = statistics::quantile(values, 0.10);
  result.p50 = statistics::quantile(values, 0.50);
  result.p90 = statistics::quantile(values, 0.90);
  return result;
}

table::Factor each_its_own(std::size_t rows) {
  table::Factor factor;
  for (std::size_t row = 0; row < rows; ++row) {
    factor.codes.push_back(static_cast<std::uint32_t>(row));
    factor.levels.push_back(std::to_string(row + 1));
  }
  return factor;
}

}  // namespace

std::vector<statistics::Score> H1Data::scores() const {
  std::vector<statistics::Score> all;
  for (std::size_t k = 0; k < predictors.size(); ++k) {
    all.push_back(score(k));
  }
  return all;
}

bool can_be_scored(H1Panel& panel) {
  if (panel.complete == 0) {
    panel.conditions.push_back(
        {statistics::ConditionKind::no_rows, statistics::ConditionSeverity::error, "", ""});
  } else if (panel.successes == 0 || panel.failures == 0) {
    panel.conditions.push_back({statistics::ConditionKind::one_class,
                                statistics::ConditionSeverity::error,
                                "",
                                panel.successes == 0 ? "no success" : "no failure"});
  } else if (panel.clusters == 1) {
    panel.conditions.push_back(
        {statistics::ConditionKind::one_cluster, statistics::ConditionSeverity::error, "", ""});
  }
  return !statistics::has_error(panel.conditions);
}

void require_columns(const table::DataTable& table, const H1Options& options) {
  for (const std::string& name : options.required) {
    if (table.find(name) == nullptr) {
      const auto nearest = table::nearest_name(name, table.header);
      throw statistics::FormulaError("no column '" + name + "' in " + table.file +
                                     (nearest ? "; did you mean '" + *nearest + "'?" : ""));
    }
  }
}

bool has_landmark(const table::DataTable& table, const H1Options& options) {
  if (options.always_landmark) {
    if (!is_there(table, options.time) && !is_there(table, "end_s")) {
      throw statistics::FormulaError(
          "--landmark: " + table.file + " has no times, neither in column '" + options.time +
          "' nor in 'end_s', so that nobody knows which trials had ended by then; "
          "name the column with --time, or leave --landmark out");
    }
    return true;
  }
  return std::all_of(
      options.predictors.begin(), options.predictors.end(), [&](const H1Predictor& predictor) {
        return !predictor.landmark_column.empty() &&
               table.find(predictor.landmark_column) != nullptr;
      });
}

H1Data panel_data(const table::DataTable& table, const H1Options& options, H1Panel& panel) {
  const PanelColumns columns = columns_of_table(table, options, panel.kind);
  panel.has_time = is_there(table, options.time);
  panel.has_clusters = columns.cluster.has_value();
  panel.has_strata = columns.strata.has_value();
  const std::vector<std::size_t> trials = trials_of_panel(table, options, columns, panel);
  count_window_ends(table, options, columns, panel);
  for (const bool success : {true, false}) {
    panel.distribution.push_back(distribution(trials, columns, success));
  }
  const std::vector<std::size_t> rows = complete_trials(trials, options, columns, panel);

  H1Data data;
  for (const std::size_t row : rows) {
    const bool success = columns.success[row] == 1.0;
    data.success.push_back(success ? 1 : 0);
    ++(success ? panel.successes : panel.failures);
  }
  for (std::size_t k = 0; k < options.predictors.size(); ++k) {
    data.predictors.push_back(on(columns.predictors[k], rows));
    data.higher.push_back(options.predictors[k].higher);
    data.names.push_back(column_of(table, options.predictors[k], panel.kind));
    if (panel.kind == H1PanelKind::landmark &&
        data.names.back() != options.predictors[k].landmark_column) {
      panel.not_of_window.push_back(data.names.back());
    }
  }
  data.cluster =
      columns.cluster ? statistics::on_rows(*columns.cluster, rows) : each_its_own(rows.size());
  if (columns.strata) {
    data.strata = statistics::on_rows(*columns.strata, rows);
    data.strata_name = options.strata;
  }
  if (columns.group) {
    data.group = statistics::on_rows(*columns.group, rows);
  }
  if (const auto within = strata_of(table, options.within, data.within_columns)) {
    data.within = statistics::on_rows(*within, rows);
  }
  panel.clusters = data.cluster.levels.size();
  if (panel.has_time) {
    add_times(on(columns.time, rows), rows, options, panel, data);
  }
  return data;
}

}  // namespace tcert::study
