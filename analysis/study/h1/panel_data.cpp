#include "analysis/study/h1/panel_data.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/quantile.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/stray_text.hpp>
#include <statistics/model/variable.hpp>
#include <table/nearest_name.hpp>

#include "analysis/study/h1/panel_columns.hpp"
#include "analysis/study/h1/panel_times.hpp"
#include "analysis/study/h1/panel_trials.hpp"
#include "analysis/study/trials/table_columns.hpp"

namespace tcert::study {
namespace {

std::vector<double> on(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  std::vector<double> kept;
  kept.reserve(rows.size());
  for (const std::size_t row : rows) {
    kept.push_back(column[row]);
  }
  return kept;
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
