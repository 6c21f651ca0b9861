#include "reports/h2_table.hpp"

#include <string>
#include <utility>

#include "reports/h1_intervals.hpp"
#include "reports/h1_within_table.hpp"
#include "reports/h2_equality.hpp"
#include "reports/h2_notes.hpp"
#include "reports/hypothesis_conditions.hpp"
#include "reports/hypothesis_findings.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using study::H2Level;
using study::H2Panel;

std::string level_text(const study::H2Table& h2) { return h1_interval_text(h2.options.trials); }

/// Those of the first panel that has strata: one that cannot be scored has none.
std::string within_columns(const study::H2Table& h2) {
  for (const H2Panel& panel : h2.panels) {
    if (!panel.trials.within.columns.empty()) {
      return h1_within_columns(panel.trials);
    }
  }
  return "";
}

ColumnsOf<InPanel<H2Level, H2Panel>> level_columns(const std::string& heading) {
  return panel_columns<H2Level, H2Panel>().text("group", heading, &H2Level::name);
}

/// Beside the whole group, pairs of trials of one stratum.
Table within_table(const study::H2Table& h2) {
  const std::string level = " within [" + level_text(h2) + "]";
  const auto columns = level_columns(h2.options.trials.group)
                           .fixed("auc", "AUC", [](auto& r) { return r->auc.value; })
                           .estimate("auc_within", "AUC" + level, &H2Level::auc_within)
                           .fixed("c", "C", [](auto& r) { return r->c.value; })
                           .estimate("c_within", "C" + level, &H2Level::c_within);
  Table table = columns.table("h2_within",
                              "H2, within " + within_columns(h2) + ": " +
                                  h2.options.trials.predictors.front().column + " by " +
                                  h2.options.trials.group,
                              rows_of(h2, &H2Panel::levels));
  for (const H2Panel& panel : h2.panels) {
    if (!panel.trials.within.columns.empty()) {
      table.footnotes.push_back(h1_within_note(panel.trials, panel_name(h2, panel)));
    }
  }
  return table;
}

Table interval_table(const study::H2Table& h2) {
  std::vector<NamedScore> scores;
  for (const auto& row : rows_of(h2, &H2Panel::levels)) {
    scores.push_back({{row->auc}, row.name, row->name, "AUC"});
    scores.push_back({{row->c}, row.name, row->name, "C"});
    scores.push_back({{row->auc_within}, row.name, row->name, "AUC within strata"});
    scores.push_back({{row->c_within}, row.name, row->name, "C within strata"});
  }
  return score_interval_table("h2_intervals", "group", h2.options.trials.group, scores);
}

Table closed_form_table(const study::H2Table& h2) {
  return level_columns("group")
      .part(closed_form_columns("auc", "SE of AUC"), [](auto& r) { return &r->auc; })
      .part(closed_form_columns("c", "SE of C"), [](auto& r) { return &r->c; })
      .p("or_p", "p of OR", [](auto& r) { return r->odds.p_value; })
      .p("hr_censored_p", "p of HR, censored", [](auto& r) { return r->censored.p_value; })
      .p("hr_at_limit_p", "p of HR, at limit", [](auto& r) { return r->at_limit.p_value; })
      .p("hr_stratified_p", "p of HR, stratified", [](auto& r) { return r->stratified.p_value; })
      .part(closed_form_columns("auc_within", "SE of AUC within"),
            [](auto& r) { return &r->auc_within; })
      .part(closed_form_columns("c_within", "SE of C within"), [](auto& r) { return &r->c_within; })
      .table("h2_closed_form", "Closed forms by cluster", rows_of(h2, &H2Panel::levels));
}

/// AUC, C, odds and hazard ratios of each group.
Table level_table(const study::H2Table& h2) {
  Table table = level_columns(h2.options.trials.group)
                    .integer("n", "n", &H2Level::trials)
                    .integer("events", "successes", &H2Level::successes)
                    .integer("clusters", "clusters", &H2Level::clusters)
                    .estimate("auc", "AUC [" + level_text(h2) + "]", &H2Level::auc)
                    .estimate("c", "C [" + level_text(h2) + "]", &H2Level::c)
                    .estimate("or", "OR per SD", &H2Level::odds)
                    .estimate("hr_censored", "HR per SD, failures censored", &H2Level::censored)
                    .estimate("hr_at_limit", "HR, failures at limit", &H2Level::at_limit)
                    .estimate("hr_stratified", "HR, stratified", &H2Level::stratified)
                    .table("h2",
                           "H2: " + h2.options.trials.predictors.front().column + " by " +
                               h2.options.trials.group,
                           rows_of(h2, &H2Panel::levels));
  table.n = static_cast<std::int64_t>(h2.trials);
  table.footnotes = h2_level_notes(h2);
  return table;
}

}  // namespace

FitReport h2_report(const study::H2Table& h2) {
  const study::H1Options& options = h2.options.trials;
  FitReport report;
  report.model = "h2";
  Record summary("summary", "Options");
  summary.integer("trials", "trials", h2.trials)
      .integer("outcome_missing", "without outcome", h2.outcome_missing)
      .text("predictor", "predictor", options.predictors.front().column)
      .text("group", "group", options.group)
      .text("success", "outcome", options.success)
      .text("time", "time", options.time)
      .text("cluster", "cluster", options.cluster)
      .text("strata", "strata", options.strata)
      .text("within", "within", within_columns(h2))
      .text("interval", "interval", std::string(statistics::to_string(options.interval)))
      .number("landmark_s", "landmark [s]", options.landmark_s)
      .number("margin", "margin", h2.options.margin)
      .number("level", "level", options.level)
      .integer("replicates", "replicates", options.replicates)
      .integer("permutations", "permutations", h2.options.permutations)
      .integer("seed", "seed", options.seed);
  report.summary = std::move(summary).table();
  report.tables = {level_table(h2)};
  if (!within_columns(h2).empty()) {
    report.tables.push_back(within_table(h2));
  }
  report.tables.insert(report.tables.end(),
                       {h2_equality_table(h2), h2_pair_table(h2), h2_interaction_table(h2)});
  report.details = {interval_table(h2), closed_form_table(h2), h2_covariance_table(h2)};
  report.conditions = conditions_of(h2);
  report.findings = h2_findings(h2);
  return report;
}

}  // namespace tcert
