#include "reports/h1_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "reports/fit/cells.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_notes.hpp"

namespace tcert {
namespace {

TableCell estimate(const study::H1Score& score) {
  return estimate_cell(score.value, score.interval);
}

TableCell ratio(const study::H1HazardRatio& one) { return estimate_cell(one.ratio, one.interval); }

TableCell better_if(const study::H1Row& row) {
  if (!row.is_single()) {
    return {};
  }
  return std::string(row.higher == statistics::HigherMeans::success ? "larger" : "smaller");
}

TableCell missing(const study::H1Row& row) {
  return row.is_single() ? integer_cell(row.missing) : TableCell{};
}

std::string level_text(const study::H1Table& h1) { return h1_interval_text(h1.options); }

}  // namespace

std::string panel_name(const study::H1Table& h1, const study::H1Panel& panel) {
  const bool alone = h1.panels.size() == 1 && panel.kind == study::H1PanelKind::paper;
  return alone ? "table" : std::string(study::to_string(panel.kind));
}

std::string h1_subject(const study::H1Table& h1) {
  const std::vector<study::H1Predictor>& predictors = h1.options.predictors;
  const std::vector<study::H1Predictor> known = study::paper_predictors();
  const bool papers = std::equal(predictors.begin(),
                                 predictors.end(),
                                 known.begin(),
                                 known.end(),
                                 [](const study::H1Predictor& a, const study::H1Predictor& b) {
                                   return a.column == b.column;
                                 });
  if (papers) {
    return "early certificate margin against contact heuristics";
  }
  std::string text = predictors.front().column;
  for (std::size_t i = 1; i < predictors.size(); ++i) {
    text += (i == 1 ? " against " : ", ") + predictors[i].column;
  }
  return text;
}

Table h1_success_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1";
  table.title = "H1, success: " + h1_subject(h1);
  table.n = static_cast<std::int64_t>(h1.trials);
  table.columns = {text_column("panel", "panel"),
                   text_column("predictor", "predictor"),
                   text_column("better", "better if"),
                   integer_column("n", "n"),
                   integer_column("events", "successes"),
                   integer_column("clusters", "clusters"),
                   integer_column("missing", "missing"),
                   estimate_column("auc", "AUC [" + level_text(h1) + "]"),
                   estimate_column("auc_gain", "gain of AUC [" + level_text(h1) + "]"),
                   p_column("p", "p"),
                   p_column("p_holm", "p Holm"),
                   fixed_column("auc_out_of_fold", "out of fold")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Row& row : panel.rows) {
      table.add_row({panel_name(h1, panel),
                     row.name,
                     better_if(row),
                     integer_cell(panel.complete),
                     integer_cell(panel.successes),
                     integer_cell(panel.clusters),
                     missing(row),
                     estimate(row.auc),
                     estimate(row.auc_gain),
                     p_cell(row.auc_p),
                     p_cell(row.auc_holm),
                     number_cell(row.auc_out_of_fold)});
    }
  }
  table.footnotes = h1_success_notes(h1);
  return table;
}

Table h1_time_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_time";
  table.title = "H1, time to egress: " + h1_subject(h1);
  table.n = static_cast<std::int64_t>(h1.trials);
  table.columns = {text_column("panel", "panel"),
                   text_column("predictor", "predictor"),
                   estimate_column("c", "C [" + level_text(h1) + "]"),
                   estimate_column("c_gain", "gain of C [" + level_text(h1) + "]"),
                   p_column("p", "p"),
                   p_column("p_holm", "p Holm"),
                   fixed_column("c_out_of_fold", "out of fold"),
                   estimate_column("hr_censored", "HR per SD, failures censored"),
                   estimate_column("hr_at_limit", "HR, failures at limit"),
                   estimate_column("hr_stratified", "HR, stratified"),
                   fixed_column("sd", "SD")};
  table.columns.back().significant = kShownDigits;
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Row& row : panel.rows) {
      table.add_row({panel_name(h1, panel),
                     row.name,
                     estimate(row.c),
                     estimate(row.c_gain),
                     p_cell(row.c_p),
                     p_cell(row.c_holm),
                     number_cell(row.c_out_of_fold),
                     ratio(row.censored),
                     ratio(row.at_limit),
                     ratio(row.stratified),
                     number_cell(row.sd)});
    }
  }
  table.footnotes = h1_time_notes(h1);
  return table;
}

}  // namespace tcert
