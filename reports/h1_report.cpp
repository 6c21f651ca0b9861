#include <algorithm>
#include <string>

#include "reports/fit/survival_report.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_table.hpp"
#include "reports/h1_within_table.hpp"
#include "reports/hypothesis_conditions.hpp"
#include "reports/hypothesis_findings.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

Table case_level_table(const study::H1Table& h1) {
  using Row = study::H1CaseRow;
  auto columns = panel_columns<Row>();
  columns.text("predictor", "predictor", &Row::name)
      .number("auc", "AUC", [](auto& r) { return r->auc.value; })
      .part(closed_form_columns("auc", "SE"), [](auto& r) { return &r->auc; })
      .p("auc_gain_p", "p of gain", &Row::auc_gain_p)
      .number("c", "C", [](auto& r) { return r->c.value; })
      .part(closed_form_columns("c", "SE"), [](auto& r) { return &r->c; })
      .p("c_gain_p", "p of gain", &Row::c_gain_p);
  Table table = columns.table("h1_case_level",
                              "Sensitivity: the same as if trials were independent",
                              rows_of(h1, &study::H1Panel::case_level));
  table.footnotes = {
      "Plain DeLong and plain jackknife: too sure of themselves where trials share a cluster. Not "
      "the result."};
  return table;
}

/// Closed forms by cluster: what another program can check to the last digit.
Table closed_form_table(const study::H1Table& h1) {
  auto columns = predictor_columns();
  columns.part(closed_form_columns("auc", "SE of AUC"), [](auto& r) { return &r->auc; })
      .number("auc_gain_std_error", "SE of its gain", [](auto& r) { return r->auc_gain.std_error; })
      .part(closed_form_columns("c", "SE of C"), [](auto& r) { return &r->c; })
      .number("c_gain_std_error", "SE of its gain", [](auto& r) { return r->c_gain.std_error; })
      .p("hr_censored_p", "p of HR, censored", [](auto& r) { return r->censored.p_value; })
      .p("hr_at_limit_p", "p of HR, at limit", [](auto& r) { return r->at_limit.p_value; })
      .p("hr_stratified_p", "p of HR, stratified", [](auto& r) { return r->stratified.p_value; })
      .p("auc_lr_p",
         "likelihood ratio of adding, trials independent: success",
         &study::H1Row::auc_lr_p)
      .p("c_lr_p", "time", &study::H1Row::c_lr_p);
  return columns.table(
      "h1_closed_form", "Closed forms by cluster", rows_of(h1, &study::H1Panel::rows));
}

Table left_out_table(const study::H1Table& h1) {
  using Row = study::H1LeftOut;
  auto columns = panel_columns<Row>();
  columns.text("without", "without", &Row::cluster)
      .text("predictor", "predictor", &Row::row)
      .number("auc", "AUC", &Row::auc)
      .number("auc_gain", "gain of AUC", &Row::auc_gain)
      .number("c", "C", &Row::c)
      .number("c_gain", "gain of C", &Row::c_gain);
  return columns.table(
      "h1_left_out", "Without each cluster in turn", rows_of(h1, &study::H1Panel::left_out));
}

Table fold_table(const study::H1Table& h1) {
  using Fold = std::pair<std::string, std::size_t>;
  auto columns = panel_columns<Fold>();
  columns.text("cluster", "cluster", &Fold::first).integer("fold", "fold", &Fold::second);
  return columns.table("h1_folds", "Folds of clusters", rows_of(h1, &study::H1Panel::folds));
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
  if (std::ranges::any_of(h1.panels, &study::H1Panel::has_time)) {
    report.tables.push_back(h1_log_time_table(h1));
  }
  report.details = {issuance_table(h1), tc_early_table(h1), case_level_table(h1)};
  add_incidence_tables(h1, report);
  report.details.insert(report.details.end(),
                        {h1_roc_table(h1), h1_calibration_table(h1), h1_recalibration_table(h1)});
  report.details.push_back(h1_interval_table(h1));
  report.details.push_back(closed_form_table(h1));
  if (has_strata) {
    report.details.push_back(h1_within_closed_form_table(h1));
  }
  report.details.push_back(left_out_table(h1));
  report.details.push_back(fold_table(h1));
  report.conditions = conditions_of(h1);
  report.findings = h1_findings(h1);
  return report;
}

}  // namespace tcert
