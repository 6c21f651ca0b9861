#include "reports/h1_table.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "reports/h1_intervals.hpp"
#include "reports/h1_notes.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using study::H1Row;

std::optional<std::string> better_if(const H1Row& row) {
  if (!row.is_single()) {
    return std::nullopt;
  }
  return row.higher == statistics::HigherMeans::success ? "larger" : "smaller";
}

}  // namespace

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
  const std::string level = h1_interval_text(h1.options);
  auto columns = predictor_columns();
  columns.estimate("auc", "AUC [" + level + "]", &H1Row::auc)
      .estimate("auc_gain", "gain of AUC [" + level + "]", &H1Row::auc_gain)
      .p("p", "p", &H1Row::auc_p)
      .p("p_holm", "p Holm", &H1Row::auc_holm)
      .fixed("auc_within_folds", "within folds", &H1Row::auc_within_folds)
      .text("better", "better if", [](auto& r) { return better_if(*r); })
      .integer("n", "n", [](auto& r) { return r.panel->complete; })
      .integer("events", "successes", [](auto& r) { return r.panel->successes; })
      .integer("clusters", "clusters", [](auto& r) { return r.panel->clusters; })
      .integer("missing", "missing", [](auto& r) { return when(r->is_single(), r->missing); });
  Table table =
      columns.table("h1", "H1, success: " + h1_subject(h1), rows_of(h1, &study::H1Panel::rows));
  table.n = static_cast<std::int64_t>(h1.trials);
  table.footnotes = h1_success_notes(h1);
  return table;
}

Table h1_time_table(const study::H1Table& h1) {
  const std::string level = h1_interval_text(h1.options);
  auto columns = predictor_columns();
  columns.estimate("c", "C [" + level + "]", &H1Row::c)
      .estimate("c_gain", "gain of C [" + level + "]", &H1Row::c_gain)
      .p("p", "p", &H1Row::c_p)
      .p("p_holm", "p Holm", &H1Row::c_holm)
      .fixed("c_within_folds", "within folds", &H1Row::c_within_folds)
      .estimate("c_at_limit", "C, failures at limit", &H1Row::c_at_limit)
      .estimate("hr_censored", "HR per SD, failures censored", &H1Row::censored)
      .estimate("hr_at_limit", "HR, failures at limit", &H1Row::at_limit)
      .estimate("hr_stratified", "HR, stratified", &H1Row::stratified)
      .fixed("sd", "SD", &H1Row::sd)
      .significant(kShownDigits);
  Table table = columns.table(
      "h1_time", "H1, time to egress: " + h1_subject(h1), rows_of(h1, &study::H1Panel::rows));
  table.n = static_cast<std::int64_t>(h1.trials);
  table.footnotes = h1_time_notes(h1);
  return table;
}

}  // namespace tcert
