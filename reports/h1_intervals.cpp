#include "reports/h1_intervals.hpp"

#include <utility>

#include "reports/fit/cells.hpp"
#include "reports/h1_table.hpp"

namespace tcert {

std::string interval_text(statistics::BootstrapMethod method, double level) {
  return significant(100.0 * level, kShownDigits) + " % " +
         std::string(statistics::to_string(method));
}

std::string h1_interval_text(const study::H1Options& options) {
  return interval_text(options.interval, options.level);
}

std::string interval_words(statistics::BootstrapMethod method) {
  switch (method) {
    case statistics::BootstrapMethod::expanded:
      return "expanded percentiles (Hesterberg 2015)";
    case statistics::BootstrapMethod::percentile:
      return "percentiles";
    case statistics::BootstrapMethod::bca:
    case statistics::BootstrapMethod::basic:
    case statistics::BootstrapMethod::normal:
      break;
  }
  return std::string(statistics::to_string(method));
}

std::vector<Column> interval_columns() {
  return {number_column("expanded_low", "expanded low"),
          number_column("expanded_high", "high"),
          number_column("percentile_low", "percentile low"),
          number_column("percentile_high", "high"),
          number_column("bca_low", "BCa low"),
          number_column("bca_high", "high")};
}

void append_intervals(const statistics::BootstrapIntervals& intervals,
                      std::vector<TableCell>& cells) {
  for (const statistics::BootstrapMethod method : {statistics::BootstrapMethod::expanded,
                                                   statistics::BootstrapMethod::percentile,
                                                   statistics::BootstrapMethod::bca}) {
    cells.push_back(low_cell(intervals.of(method)));
    cells.push_back(high_cell(intervals.of(method)));
  }
}

void add_no_bca(const std::string& of,
                const statistics::BootstrapIntervals& intervals,
                Table& table) {
  if (intervals.no_bca) {
    table.footnotes.push_back(
        of + ", no BCa interval: " + statistics::to_string(*intervals.no_bca) + ".");
  }
}

Table h1_interval_columns(std::string name, std::string row_name, std::string row_heading) {
  Table table;
  table.name = std::move(name);
  table.title = "Bootstrap intervals of the same resamples by three methods";
  table.columns = {text_column("panel", "panel"),
                   text_column(std::move(row_name), std::move(row_heading)),
                   text_column("quantity", "of"),
                   number_column("estimate", "estimate")};
  const std::vector<Column> ends = interval_columns();
  table.columns.insert(table.columns.end(), ends.begin(), ends.end());
  return table;
}

void add_intervals(const std::string& panel,
                   const std::string& row,
                   const std::string& quantity,
                   const study::H1Score& score,
                   Table& table) {
  if (!score.value) {
    return;
  }
  std::vector<TableCell> cells{panel, row, quantity, number_cell(score.value)};
  append_intervals(score.intervals, cells);
  table.add_row(std::move(cells));
  std::string of = panel;
  of.append(", ").append(row).append(", ").append(quantity);
  add_no_bca(of, score.intervals, table);
}

Table h1_interval_table(const study::H1Table& h1) {
  Table table = h1_interval_columns("h1_intervals", "predictor", "predictor");
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Row& row : panel.rows) {
      const auto add = [&](const char* quantity, const study::H1Score& score) {
        add_intervals(panel_name(h1, panel), row.name, quantity, score, table);
      };
      add("AUC", row.auc);
      add("gain of AUC", row.auc_gain);
      add("C", row.c);
      add("gain of C", row.c_gain);
      add("AUC within strata", row.within.auc);
      add("gain of AUC within strata", row.within.auc_gain);
      add("C within strata", row.within.c);
      add("gain of C within strata", row.within.c_gain);
    }
  }
  return table;
}

}  // namespace tcert
