#include "reports/h1_within_table.hpp"

#include "reports/h1_intervals.hpp"
#include "reports/h1_table.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using study::H1Row;

std::string percent(std::size_t part, std::size_t whole) {
  return whole == 0
             ? "NA"
             : fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %";
}

/// Rows of models have nothing within strata.
std::vector<InPanel<H1Row>> predictors_of(const study::H1Table& h1) {
  std::vector<InPanel<H1Row>> rows = rows_of(h1, &study::H1Panel::rows);
  std::erase_if(rows, [](const auto& row) { return !row->is_single(); });
  return rows;
}

/// Pooled and within strata, of one outcome.
Table within_table(const study::H1Table& h1,
                   const std::string& name,
                   const std::string& outcome,
                   const ColumnsOf<InPanel<H1Row>>& columns) {
  Table table = columns.table(
      name,
      "H1, " + outcome + ", " + "within " + h1_within_columns(h1) + ": " + h1_subject(h1),
      predictors_of(h1));
  table.n = static_cast<std::int64_t>(h1.trials);
  return table;
}

}  // namespace

std::string h1_within_columns(const study::H1Panel& panel) {
  std::string text;
  for (const std::string& column : panel.within.columns) {
    text += (text.empty() ? "" : " x ") + column;
  }
  return text;
}

std::string h1_within_columns(const study::H1Table& h1) {
  for (const study::H1Panel& panel : h1.panels) {
    if (!panel.within.columns.empty()) {
      return h1_within_columns(panel);
    }
  }
  return "";
}

std::string h1_within_note(const study::H1Panel& panel, const std::string& name) {
  const study::H1Strata& within = panel.within;
  std::string note = "Within, " + name + ": pairs of trials of the same " +
                     h1_within_columns(panel) + " alone, " + std::to_string(within.levels) +
                     " strata with " + percent(within.auc_pairs, within.all_auc_pairs) +
                     " of the pairs that the AUC compares";
  if (within.all_c_pairs > 0) {
    note += " and " + percent(within.c_pairs, within.all_c_pairs) + " of those of C";
  }
  if (within.missing > 0) {
    note += "; " + std::to_string(within.missing) + " trials of an unknown stratum are in no pair";
  }
  return note + ".";
}

Table h1_within_table(const study::H1Table& h1) {
  const std::string level = " within [" + h1_interval_text(h1.options) + "]";
  auto columns = predictor_columns();
  columns.fixed("auc", "AUC", [](auto& r) { return r->auc.value; })
      .estimate("auc_within", "AUC" + level, [](auto& r) { return r->within.auc; })
      .fixed("auc_gain", "gain of AUC", [](auto& r) { return r->auc_gain.value; })
      .estimate(
          "auc_gain_within", "gain of AUC" + level, [](auto& r) { return r->within.auc_gain; })
      .estimate(
          "auc_gain_between", "gain between", [](auto& r) { return r->within.auc_gain_between; });
  Table table = within_table(h1, "h1_within", "success", columns);
  table.footnotes.emplace_back(
      "Pooled numbers compare every pair of trials, also of groups that differ in speed or in "
      "light before a trial begins. Between: the gain less that within, which is what the groups "
      "add to it; the two sum up to the gain.");
  for (const study::H1Panel& panel : h1.panels) {
    if (!panel.within.columns.empty()) {
      table.footnotes.push_back(h1_within_note(panel, panel_name(h1, panel)));
    }
  }
  table.footnotes.emplace_back(
      "Intervals and gains: as in the table of success, on the same resamples; no test, so that "
      "the family stays what it was.");
  return table;
}

Table h1_time_within_table(const study::H1Table& h1) {
  const std::string level = " within [" + h1_interval_text(h1.options) + "]";
  auto columns = predictor_columns();
  columns.fixed("c", "C", [](auto& r) { return r->c.value; })
      .estimate("c_within", "C" + level, [](auto& r) { return r->within.c; })
      .fixed("c_gain", "gain of C", [](auto& r) { return r->c_gain.value; })
      .estimate("c_gain_within", "gain of C" + level, [](auto& r) { return r->within.c_gain; })
      .estimate("c_gain_between", "gain between", [](auto& r) { return r->within.c_gain_between; });
  Table table = within_table(h1, "h1_time_within", "time to egress", columns);
  table.footnotes.emplace_back("Strata and pairs: see the table of success.");
  return table;
}

Table h1_within_closed_form_table(const study::H1Table& h1) {
  const char* const gain = "SE of its gain";
  Table table =
      predictor_columns()
          .integer("strata", "strata", [](auto& r) { return r.panel->within.levels; })
          .integer("auc_pairs", "pairs of AUC", [](auto& r) { return r.panel->within.auc_pairs; })
          .part(closed_form_columns("auc", "SE of AUC"), [](auto& r) { return &r->within.auc; })
          .number("auc_gain_std_error", gain, [](auto& r) { return r->within.auc_gain.std_error; })
          .p("auc_gain_p", "p of gain", [](auto& r) { return r->within.auc_gain_p; })
          .integer("c_pairs", "pairs of C", [](auto& r) { return r.panel->within.c_pairs; })
          .part(closed_form_columns("c", "SE of C"), [](auto& r) { return &r->within.c; })
          .number("c_gain_std_error", gain, [](auto& r) { return r->within.c_gain.std_error; })
          .p("c_gain_p", "p of gain", [](auto& r) { return r->within.c_gain_p; })
          .table(
              "h1_within_closed_form", "Closed forms by cluster, within strata", predictors_of(h1));
  table.footnotes = {"Clustered jackknife of both, as survival's concordance with strata."};
  return table;
}

}  // namespace tcert
