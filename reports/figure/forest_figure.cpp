#include "reports/figure/h1_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

/// A ratio that the forest shows: table, column, title.
struct Ratio {
  const Table* table;
  const char* column;
  const char* title;
};

}  // namespace

std::optional<Figure> forest_figure(const Table& h1_mixed, const Table& h1_time) {
  if (h1_mixed.rows.empty() && h1_time.rows.empty()) {
    return std::nullopt;
  }
  const Table& first = h1_mixed.rows.empty() ? h1_time : h1_mixed;
  const std::string panel = distinct(first, "panel").back();
  Figure figure = named("forest", "Effects per standard deviation", first.synthetic);
  figure.caption =
      "Odds ratios of success (mixed model, random intercept by day) and hazard ratios of egress "
      "(Cox, cluster-robust) per standard deviation towards the better side, with 95 % intervals" +
      std::string(panel == "landmark" ? "; landmark panel." : ".");
  figure.data =
      figure_table("forest", {"panel", "predictor"}, {"ratio", "ratio_low", "ratio_high"});
  const std::array<Ratio, 4> ratios = {
      {{&h1_mixed, "or_per_sd", "OR of success"},
       {&h1_time, "hr_censored", "HR of egress, failures censored"},
       {&h1_time, "hr_at_limit", "HR of egress, failures at limit"},
       {&h1_time, "hr_stratified", "HR of egress, stratified"}}};
  for (const Ratio& ratio : ratios) {
    double low = 1.0;
    double high = 1.0;
    std::vector<std::string> shown;
    for (std::size_t row = 0; row < ratio.table->rows.size(); ++row) {
      const std::string name = ratio.column;
      const double value = number_at(*ratio.table, row, name);
      if (text_at(*ratio.table, row, "panel") != panel || !std::isfinite(value)) {
        continue;
      }
      const double from = number_at(*ratio.table, row, name + "_low");
      const double to = number_at(*ratio.table, row, name + "_high");
      low = std::min({low, value, std::isfinite(from) ? from : value});
      high = std::max({high, value, std::isfinite(to) ? to : value});
      const std::string label = predictor_label(text_at(*ratio.table, row, "predictor"));
      add_figure_row(figure.data, "effect", {ratio.title, label}, {value, from, to});
      shown.push_back(label);
    }
    if (shown.empty()) {
      continue;
    }
    Panel one = interval_panel("effect", "ratio", "predictor", shown);
    one.title = ratio.title;
    one.name = ratio.title;
    one.x = axis("ratio per SD, log scale");
    one.x.scale = AxisScale::log;
    one.x.low = low / 1.08;
    one.x.high = high * 1.08;
    one.x.ticks = ratio_ticks(*one.x.low, *one.x.high);
    one.references = {{true, 1.0, true}};
    one.height = 0.62;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = 2;
  return finished(std::move(figure));
}

}  // namespace tcert
