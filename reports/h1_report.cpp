#include <algorithm>
#include <string>

#include "reports/fit/cells.hpp"
#include "reports/fit/survival_report.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_table.hpp"
#include "reports/h1_within_table.hpp"

namespace tcert {
namespace {

Table case_level_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_case_level";
  table.title = "Sensitivity: the same as if trials were independent";
  table.columns = {text_column("panel", "panel"),
                   text_column("predictor", "predictor"),
                   number_column("auc", "AUC"),
                   number_column("auc_std_error", "SE"),
                   number_column("auc_low", "low"),
                   number_column("auc_high", "high"),
                   p_column("auc_gain_p", "p of gain"),
                   number_column("c", "C"),
                   number_column("c_std_error", "SE"),
                   number_column("c_low", "low"),
                   number_column("c_high", "high"),
                   p_column("c_gain_p", "p of gain")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1CaseRow& row : panel.case_level) {
      table.add_row({panel_name(h1, panel),
                     row.name,
                     number_cell(row.auc.value),
                     number_cell(row.auc.std_error),
                     low_cell(row.auc.closed_form),
                     high_cell(row.auc.closed_form),
                     p_cell(row.auc_gain_p),
                     number_cell(row.c.value),
                     number_cell(row.c.std_error),
                     low_cell(row.c.closed_form),
                     high_cell(row.c.closed_form),
                     p_cell(row.c_gain_p)});
    }
  }
  table.footnotes = {
      "Plain DeLong and plain jackknife: too sure of themselves where trials share a cluster. Not "
      "the result."};
  return table;
}

/// Closed forms by cluster: what another program can check to the last digit.
Table closed_form_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_closed_form";
  table.title = "Closed forms by cluster";
  table.columns = {text_column("panel", "panel"),
                   text_column("predictor", "predictor"),
                   number_column("auc_std_error", "SE of AUC"),
                   number_column("auc_low", "low"),
                   number_column("auc_high", "high"),
                   number_column("auc_gain_std_error", "SE of its gain"),
                   number_column("c_std_error", "SE of C"),
                   number_column("c_low", "low"),
                   number_column("c_high", "high"),
                   number_column("c_gain_std_error", "SE of its gain"),
                   p_column("hr_censored_p", "p of HR, censored"),
                   p_column("hr_at_limit_p", "p of HR, at limit"),
                   p_column("hr_stratified_p", "p of HR, stratified"),
                   p_column("auc_lr_p", "likelihood ratio of adding, trials independent: success"),
                   p_column("c_lr_p", "time")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Row& row : panel.rows) {
      table.add_row({panel_name(h1, panel),
                     row.name,
                     number_cell(row.auc.std_error),
                     low_cell(row.auc.closed_form),
                     high_cell(row.auc.closed_form),
                     number_cell(row.auc_gain.std_error),
                     number_cell(row.c.std_error),
                     low_cell(row.c.closed_form),
                     high_cell(row.c.closed_form),
                     number_cell(row.c_gain.std_error),
                     p_cell(row.censored.p_value),
                     p_cell(row.at_limit.p_value),
                     p_cell(row.stratified.p_value),
                     p_cell(row.auc_lr_p),
                     p_cell(row.c_lr_p)});
    }
  }
  return table;
}

Table fold_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_folds";
  table.title = "Folds of clusters";
  table.columns = {text_column("panel", "panel"),
                   text_column("cluster", "cluster"),
                   integer_column("fold", "fold")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const auto& [cluster, fold] : panel.folds) {
      table.add_row({panel_name(h1, panel), cluster, integer_cell(fold)});
    }
  }
  return table;
}

/// Incidence of both panels in one table: a column `panel` before the others.
Table with_panel(const std::vector<std::pair<std::string, Table>>& parts, std::string name) {
  Table table = parts.front().second;
  table.name = std::move(name);
  table.rows.clear();
  table.columns.insert(table.columns.begin(), text_column("panel", "panel"));
  for (const auto& [panel, part] : parts) {
    for (std::vector<TableCell> cells : part.rows) {
      cells.insert(cells.begin(), panel);
      table.add_row(std::move(cells));
    }
  }
  return table;
}

void add_incidence_tables(const study::H1Table& h1, FitReport& report) {
  std::vector<std::pair<std::string, Table>> shown;
  std::vector<std::pair<std::string, Table>> all;
  for (const study::H1Panel& panel : h1.panels) {
    if (panel.incidence.empty()) {
      continue;
    }
    SurvivalReportOptions options;
    options.scale = statistics::IntervalScale::log_log;
    options.level = h1.options.level;
    options.limit = h1.options.limit_s;
    FitReport part;
    add_incidence(panel.incidence, options, part);
    shown.emplace_back(panel_name(h1, panel), part.tables.front());
    all.emplace_back(panel_name(h1, panel), part.details.front());
  }
  if (!shown.empty()) {
    report.details.push_back(with_panel(shown, "h1_incidence"));
    report.details.back().title =
        "Cumulative incidence by quartile of the predictor (Q1 lowest), Aalen-Johansen";
    report.details.push_back(with_panel(all, "h1_incidence_curve"));
  }
}

}  // namespace

FitReport h1_report(const study::H1Table& h1) {
  FitReport report;
  report.model = "h1";
  const bool has_landmark =
      std::any_of(h1.panels.begin(), h1.panels.end(), [](const study::H1Panel& panel) {
        return panel.kind == study::H1PanelKind::landmark;
      });
  Record summary("summary", "Options");
  summary.integer("trials", "trials", h1.trials)
      .integer("outcome_missing", "without outcome", h1.outcome_missing)
      .text("predictor", "predictor", h1.options.predictors.front().column)
      .text("success", "outcome", h1.options.success)
      .text("time", "time", h1.options.time)
      .text("cluster", "cluster", h1.options.cluster)
      .text("strata", "strata", h1.options.strata)
      .text("within", "within", h1_within_columns(h1))
      .text("interval", "interval", std::string(statistics::to_string(h1.options.interval)))
      .number("landmark_s",
              "landmark [s]",
              has_landmark ? std::optional(h1.options.landmark_s) : std::nullopt)
      .number("level", "level", h1.options.level)
      .integer("replicates", "replicates", h1.options.replicates)
      .integer("folds", "folds", h1.options.folds)
      .integer("seed", "seed", h1.options.seed);
  report.summary = std::move(summary).table();
  const bool has_strata =
      std::any_of(h1.panels.begin(), h1.panels.end(), [](const study::H1Panel& panel) {
        return !panel.within.columns.empty();
      });
  report.tables = {h1_success_table(h1)};
  if (has_strata) {
    report.tables.push_back(h1_within_table(h1));
  }
  report.tables.push_back(h1_time_table(h1));
  if (has_strata) {
    report.tables.push_back(h1_time_within_table(h1));
  }
  report.tables.push_back(h1_mixed_table(h1));
  report.details = {issuance_table(h1), tc_early_table(h1), case_level_table(h1)};
  add_incidence_tables(h1, report);
  report.details.insert(report.details.end(),
                        {h1_roc_table(h1), h1_calibration_table(h1), h1_recalibration_table(h1)});
  report.details.push_back(h1_interval_table(h1));
  report.details.push_back(closed_form_table(h1));
  if (has_strata) {
    report.details.push_back(h1_within_closed_form_table(h1));
  }
  report.details.push_back(fold_table(h1));
  for (const study::H1Panel& panel : h1.panels) {
    report.conditions.insert(
        report.conditions.end(), panel.conditions.begin(), panel.conditions.end());
    for (const study::H1Row& row : panel.rows) {
      report.conditions.insert(
          report.conditions.end(), row.conditions.begin(), row.conditions.end());
    }
  }
  return report;
}

}  // namespace tcert
