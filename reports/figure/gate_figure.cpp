#include "reports/figure/set_figures.hpp"

#include <table/not_a_number.hpp>

#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
std::optional<Figure> gate_figure(const Table& gate,
                                  const Table& passes,
                                  const Table& curve,
                                  const Table& calibration) {
  Figure figure = named("gate", "Chance to pass a gate by its margin", passes.synthetic);
  figure.caption =
      "Fitted chance with its pointwise 95 % interval, passes as marks at 0 and 1, five groups of "
      "like margin with Wilson's intervals, and the margin of an even chance with its profile "
      "interval.";
  figure.key = {"", {"fit", "passes", "groups of passes", "even chance"}};
  figure.data = figure_table("gate", {}, {"margin_m", "chance", "low", "high"});
  Panel one;
  one.x = axis("smallest margin of the pass", "m");
  one.y = axis("chance to pass");
  one.y.low = -0.05;
  one.y.high = 1.05;
  one.y.ticks = {0.0, 0.25, 0.5, 0.75, 1.0};
  one.references = {{true, 0.0, false}, {false, 0.5, false}};
  for (std::size_t row = 0; row < curve.rows.size(); ++row) {
    add_figure_row(figure.data,
                   "curve",
                   {},
                   {number_at(curve, row, "margin_m"),
                    number_at(curve, row, "chance"),
                    number_at(curve, row, "chance_low"),
                    number_at(curve, row, "chance_high")});
  }
  for (std::size_t row = 0; row < passes.rows.size(); ++row) {
    add_figure_row(figure.data,
                   "pass",
                   {},
                   {number_at(passes, row, "bottleneck_m"),
                    number_at(passes, row, "success"),
                    table::kNaN,
                    table::kNaN});
  }
  for (std::size_t row = 0; row < calibration.rows.size(); ++row) {
    add_figure_row(figure.data,
                   "group",
                   {},
                   {number_at(calibration, row, "mean_margin_m"),
                    number_at(calibration, row, "observed"),
                    number_at(calibration, row, "observed_low"),
                    number_at(calibration, row, "observed_high")});
  }
  for (std::size_t row = 0; row < gate.rows.size(); ++row) {
    if (text_at(gate, row, "method") == "profile") {
      add_figure_row(figure.data,
                     "even",
                     {},
                     {number_at(gate, row, "point_m"),
                      0.5,
                      number_at(gate, row, "low_m"),
                      number_at(gate, row, "high_m")});
    }
  }
  Extent extent;
  extent.add(0.0);
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    extent.add(number_at(figure.data, row, "margin_m"));
  }
  extent.apply(one.x);
  Layer band = layer(Mark::band, "curve", "margin_m", "low");
  band.y2 = "high";
  band.label = "fit";
  Layer line = layer(Mark::line, "curve", "margin_m", "chance");
  line.label = "fit";
  line.width = 2.0;
  Layer pass = layer(Mark::point, "pass", "margin_m", "chance");
  pass.label = "passes";
  pass.hollow = true;
  Layer group_range = range_y("group", "margin_m", "low", "high");
  group_range.label = "groups of passes";
  Layer group = layer(Mark::point, "group", "margin_m", "chance");
  group.label = "groups of passes";
  group.size = 1.5;
  Layer even_range = range_x("even", "low", "high", "chance");
  even_range.label = "even chance";
  even_range.width = 2.5;
  Layer even = layer(Mark::point, "even", "margin_m", "chance");
  even.label = "even chance";
  even.size = 1.8;
  one.layers = {band, line, pass, group_range, group, even_range, even};
  one.height = 1.1;
  figure.panels = {std::move(one)};
  return finished(std::move(figure));
}

}  // namespace tcert
