#include "reports/figure/h1_figures.hpp"

#include <table/not_a_number.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
std::optional<Figure> calibration_figure(const Table& h1_calibration) {
  const Table& from = h1_calibration;
  Figure figure = named("calibration", "Success: out-of-fold calibration", from.synthetic);
  figure.caption =
      "Observed share of successes in tenths of the predicted probability, with Wilson's "
      "intervals. "
      "Predictions by models that have not seen the trial's day. Dashed: perfect.";
  figure.key.classes = predictor_labels(distinct(from, "model"));
  figure.data = figure_table("calibration",
                             {"panel", "model"},
                             {"predicted", "observed", "observed_low", "observed_high", "trials"});
  double least = 1.0;
  for (std::size_t row = 0; row < from.rows.size(); ++row) {
    const double predicted = number_at(from, row, "predicted");
    const double observed = number_at(from, row, "observed");
    const double low = number_at(from, row, "observed_low");
    least = std::min({least, predicted, observed, std::isfinite(low) ? low : observed});
    add_figure_row(figure.data,
                   "bin",
                   {text_at(from, row, "panel"), predictor_label(text_at(from, row, "model"))},
                   {predicted,
                    observed,
                    low,
                    number_at(from, row, "observed_high"),
                    number_at(from, row, "n")});
  }
  const double low = std::max(0.0, std::floor(least * 10.0) / 10.0);
  for (const std::string& panel : distinct(from, "panel")) {
    add_figure_row(
        figure.data, "ideal", {panel, ""}, {low, low, table::kNaN, table::kNaN, table::kNaN});
    add_figure_row(
        figure.data, "ideal", {panel, ""}, {1.0, 1.0, table::kNaN, table::kNaN, table::kNaN});
    Panel one;
    one.title = panel_title(panel);
    one.name = panel;
    one.x = axis("predicted probability of success");
    one.y = axis("observed share of successes");
    one.x.low = one.y.low = low - 0.01;
    one.x.high = one.y.high = 1.01;
    Layer range = range_y("bin", "predicted", "observed_low", "observed_high");
    range.colour = "model";
    range.width = 1.0;
    Layer line = layer(Mark::line, "bin", "predicted", "observed");
    line.colour = "model";
    line.width = 1.0;
    Layer point = line;
    point.mark = Mark::point;
    point.size = 1.2;
    one.layers = {guide("ideal", "predicted", "observed"), range, line, point};
    one.height = 1.15;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = 2;
  return finished(std::move(figure));
}

}  // namespace tcert
