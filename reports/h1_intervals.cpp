#include "reports/h1_intervals.hpp"

#include <utility>

#include "reports/panel_rows.hpp"

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

ColumnsOf<statistics::BootstrapIntervals> bootstrap_columns() {
  using Intervals = statistics::BootstrapIntervals;
  return ColumnsOf<Intervals>()
      .ends({"expanded_low", "expanded low"}, {"expanded_high", "high"}, &Intervals::expanded)
      .ends(
          {"percentile_low", "percentile low"}, {"percentile_high", "high"}, &Intervals::percentile)
      .ends({"bca_low", "BCa low"}, {"bca_high", "high"}, &Intervals::bca);
}

void add_no_bca(const std::string& of,
                const statistics::BootstrapIntervals& intervals,
                Table& table) {
  if (intervals.no_bca) {
    table.footnotes.push_back(
        of + ", no BCa interval: " + statistics::to_string(*intervals.no_bca) + ".");
  }
}

Table score_interval_table(std::string name,
                           std::string_view row_name,
                           std::string_view row_heading,
                           const std::vector<NamedScore>& scores) {
  const auto columns = ColumnsOf<NamedScore>()
                           .text("panel", "panel", &NamedScore::panel)
                           .text(row_name, row_heading, &NamedScore::row)
                           .text("quantity", "of", &NamedScore::quantity)
                           .number("estimate", "estimate", &study::H1Score::value)
                           .part(bootstrap_columns(), [](auto& one) { return &one.of.intervals; });
  Table table =
      columns.table(std::move(name), "Bootstrap intervals of the same resamples by three methods");
  for (const NamedScore& one : scores) {
    if (one.of.value) {
      table.add_row(columns.row(one));
      add_no_bca(one.panel + ", " + one.row + ", " + one.quantity, one.of.intervals, table);
    }
  }
  return table;
}

Table h1_interval_table(const study::H1Table& h1) {
  std::vector<NamedScore> scores;
  for (const auto& row : rows_of(h1, &study::H1Panel::rows)) {
    const auto add = [&](const char* quantity, const study::H1Score& score) {
      scores.push_back({{score}, row.name, row->name, quantity});
    };
    add("AUC", row->auc);
    add("gain of AUC", row->auc_gain);
    add("C", row->c);
    add("gain of C", row->c_gain);
    add("AUC within strata", row->within.auc);
    add("gain of AUC within strata", row->within.auc_gain);
    add("C within strata", row->within.c);
    add("gain of C within strata", row->within.c_gain);
  }
  return score_interval_table("h1_intervals", "predictor", "predictor", scores);
}

}  // namespace tcert
