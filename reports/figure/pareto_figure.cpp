#include "reports/figure/set_figures.hpp"

#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

/// A law at one lighting.
void add_case(const Table& h3, std::size_t row, const std::string& law, Figure& figure) {
  const bool front = text_at(h3, row, "on_front") == "yes";
  add_figure_row(figure.data,
                 front ? "front" : "behind",
                 {text_at(h3, row, "lighting"),
                  law,
                  "\u03b2 " + significant(number_at(h3, row, "beta_per_m"), 4)},
                 {number_at(h3, row, "beta_per_m"),
                  number_at(h3, row, "gain_share"),
                  number_at(h3, row, "gain_share_low"),
                  number_at(h3, row, "gain_share_high"),
                  number_at(h3, row, "retained"),
                  number_at(h3, row, "retained_low"),
                  number_at(h3, row, "retained_high")});
}

}  // namespace

std::optional<Figure> pareto_figure(const Table& h3) {
  Figure figure = named("pareto", "Gain of speed against successes retained", h3.synthetic);
  figure.caption = "Every law and \u03b2: relative gain of the rate of advance (" +
                   intervals_of(h3, "gain_share") +
                   ") against the share of successes retained (Wilson); \u03b2 in 1/m. Filled: on "
                   "the Pareto front of its lighting. "
                   "A replay can "
                   "only lose successes.";
  figure.key = {"speed law", distinct(h3, "speed_law")};
  figure.data = figure_table("pareto",
                             {"panel", "law", "beta"},
                             {"beta_per_m",
                              "gain_share",
                              "gain_share_low",
                              "gain_share_high",
                              "retained",
                              "retained_low",
                              "retained_high"});
  Extent gains;
  Extent kept;
  for (std::size_t row = 0; row < h3.rows.size(); ++row) {
    add_case(h3, row, text_at(h3, row, "speed_law"), figure);
    gains.add(number_at(h3, row, "gain_share_low"));
    gains.add(number_at(h3, row, "gain_share_high"));
    kept.add(number_at(h3, row, "retained_low"));
    kept.add(number_at(h3, row, "retained_high"));
  }
  for (const std::string& lighting : distinct(h3, "lighting")) {
    Panel one;
    one.name = lighting;
    one.title = lighting == "all" ? "all lightings" : lighting;
    one.x = axis("relative gain of the rate of advance");
    one.y = axis("successes retained (share)");
    gains.apply(one.x, 0.08);
    kept.apply(one.y, 0.1);
    one.references = {{true, 0.0, false}};
    for (const char* part : {"behind", "front"}) {
      Layer across = range_x(part, "gain_share_low", "gain_share_high", "retained");
      across.colour = "law";
      across.width = 0.8;
      Layer up = range_y(part, "gain_share", "retained_low", "retained_high");
      up.colour = "law";
      up.width = 0.8;
      Layer point = layer(Mark::point, part, "gain_share", "retained");
      point.colour = "law";
      point.size = 1.6;
      point.hollow = std::string_view(part) == "behind";
      Layer beta = layer(Mark::text, part, "gain_share", "retained");
      beta.text = "beta";
      beta.raise = 0.9;
      one.layers.insert(one.layers.end(), {across, up, point, beta});
    }
    one.height = 0.85;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = 2;
  return finished(std::move(figure));
}

}  // namespace tcert
