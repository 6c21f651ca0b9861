#include "reports/h1_within_table.hpp"

#include "reports/fit/cells.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_table.hpp"

namespace tcert {
namespace {

TableCell estimate(const study::H1Score& score) {
  return estimate_cell(score.value, score.interval);
}

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0
             ? "NA"
             : fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %";
}

/// Pooled and within strata, of one outcome.
struct Pair {
  const study::H1Score& pooled;
  const study::H1Score& pooled_gain;
  const study::H1Score& within;
  const study::H1Score& within_gain;
};

template <class PairOf>
Table within_table(const study::H1Table& h1,
                   const std::string& name,
                   const std::string& outcome,
                   const std::string& column,
                   const std::string& symbol,
                   const PairOf& pair_of) {
  const std::string level = h1_interval_text(h1.options);
  Table table;
  table.name = name;
  table.title = "H1, " + outcome + ", " + "within " + h1_within_columns(h1) + ": " + h1_subject(h1);
  table.n = static_cast<std::int64_t>(h1.trials);
  table.columns = {
      text_column("panel", "panel"),
      text_column("predictor", "predictor"),
      fixed_column(column, symbol),
      estimate_column(column + "_within", symbol + " within [" + level + "]"),
      fixed_column(column + "_gain", "gain of " + symbol),
      estimate_column(column + "_gain_within", "gain of " + symbol + " within [" + level + "]")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Row& row : panel.rows) {
      if (!row.is_single()) {
        continue;
      }
      const Pair pair = pair_of(row);
      table.add_row({panel_name(h1, panel),
                     row.name,
                     number_cell(pair.pooled.value),
                     estimate(pair.within),
                     number_cell(pair.pooled_gain.value),
                     estimate(pair.within_gain)});
    }
  }
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
                     " strata with " + share(within.auc_pairs, within.all_auc_pairs) +
                     " of the pairs that the AUC compares";
  if (within.all_c_pairs > 0) {
    note += " and " + share(within.c_pairs, within.all_c_pairs) + " of those of C";
  }
  if (within.missing > 0) {
    note += "; " + std::to_string(within.missing) + " trials of an unknown stratum are in no pair";
  }
  return note + ".";
}

Table h1_within_table(const study::H1Table& h1) {
  Table table = within_table(h1, "h1_within", "success", "auc", "AUC", [](const study::H1Row& row) {
    return Pair{row.auc, row.auc_gain, row.within.auc, row.within.auc_gain};
  });
  table.footnotes.emplace_back(
      "Pooled numbers compare every pair of trials, also of groups that differ in speed or in "
      "light before a trial begins; a gain that vanishes within strata is one between groups.");
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
  Table table =
      within_table(h1, "h1_time_within", "time to egress", "c", "C", [](const study::H1Row& row) {
        return Pair{row.c, row.c_gain, row.within.c, row.within.c_gain};
      });
  table.footnotes.emplace_back("Strata and pairs: see the table of success.");
  return table;
}

Table h1_within_closed_form_table(const study::H1Table& h1) {
  Table table;
  table.name = "h1_within_closed_form";
  table.title = "Closed forms by cluster, within strata";
  table.columns = {text_column("panel", "panel"),
                   text_column("predictor", "predictor"),
                   integer_column("strata", "strata"),
                   integer_column("auc_pairs", "pairs of AUC"),
                   number_column("auc_std_error", "SE of AUC"),
                   number_column("auc_low", "low"),
                   number_column("auc_high", "high"),
                   number_column("auc_gain_std_error", "SE of its gain"),
                   p_column("auc_gain_p", "p of gain"),
                   integer_column("c_pairs", "pairs of C"),
                   number_column("c_std_error", "SE of C"),
                   number_column("c_low", "low"),
                   number_column("c_high", "high"),
                   number_column("c_gain_std_error", "SE of its gain"),
                   p_column("c_gain_p", "p of gain")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Row& row : panel.rows) {
      if (!row.is_single()) {
        continue;
      }
      const study::H1WithinScores& within = row.within;
      table.add_row({panel_name(h1, panel),
                     row.name,
                     integer_cell(panel.within.levels),
                     integer_cell(panel.within.auc_pairs),
                     number_cell(within.auc.std_error),
                     low_cell(within.auc.closed_form),
                     high_cell(within.auc.closed_form),
                     number_cell(within.auc_gain.std_error),
                     p_cell(within.auc_gain_p),
                     integer_cell(panel.within.c_pairs),
                     number_cell(within.c.std_error),
                     low_cell(within.c.closed_form),
                     high_cell(within.c.closed_form),
                     number_cell(within.c_gain.std_error),
                     p_cell(within.c_gain_p)});
    }
  }
  table.footnotes = {"Clustered jackknife of both, as survival's concordance with strata."};
  return table;
}

}  // namespace tcert
