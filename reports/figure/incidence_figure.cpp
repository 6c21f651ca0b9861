#include "reports/figure/h1_figures.hpp"

#include <table/not_a_number.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr int kRiskTimes = 6;

/// One group of one panel of the incidence curve.
struct Incidence {
  std::vector<double> time, risk, estimate, low, high;
};

Incidence incidence_of(const Table& table, const std::string& panel, const std::string& group) {
  Incidence curve;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (text_at(table, row, "panel") == panel && text_at(table, row, "strata") == group &&
        text_at(table, row, "state") == "egress") {
      curve.time.push_back(number_at(table, row, "time"));
      curve.risk.push_back(number_at(table, row, "n.risk"));
      curve.estimate.push_back(number_at(table, row, "estimate"));
      curve.low.push_back(number_at(table, row, "conf.low"));
      curve.high.push_back(number_at(table, row, "conf.high"));
    }
  }
  return curve;
}

double at_risk(const Incidence& curve, double time) {
  const auto next = std::lower_bound(curve.time.begin(), curve.time.end(), time);
  return next == curve.time.end() ? 0.0
                                  : curve.risk[static_cast<std::size_t>(next - curve.time.begin())];
}

void add_incidence_rows(const std::string& panel,
                        const std::string& group,
                        const Incidence& curve,
                        const std::vector<double>& times,
                        Table& data) {
  add_figure_row(data, "curve", {panel, group, ""}, {0.0, 0.0, table::kNaN, table::kNaN});
  double low = table::kNaN;
  double high = table::kNaN;
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    const bool last = i + 1 == curve.time.size();
    if (i > 0 && curve.estimate[i] == curve.estimate[i - 1] && !last) {
      continue;
    }
    add_figure_row(data,
                   "curve",
                   {panel, group, ""},
                   {curve.time[i], curve.estimate[i], table::kNaN, table::kNaN});
    // The band has corners: what it was until now, and what it is from now on.
    if (std::isfinite(low)) {
      add_figure_row(data, "band", {panel, group, ""}, {curve.time[i], table::kNaN, low, high});
    }
    low = curve.low[i];
    high = curve.high[i];
    if (std::isfinite(low)) {
      add_figure_row(data, "band", {panel, group, ""}, {curve.time[i], table::kNaN, low, high});
    }
  }
  for (const double time : times) {
    add_figure_row(data,
                   "risk",
                   {panel, group, fixed(at_risk(curve, time), 0)},
                   {time, table::kNaN, table::kNaN, table::kNaN});
  }
}

}  // namespace

std::optional<Figure> incidence_figure(const Table& h1_incidence_curve,
                                       const std::string& predictor) {
  const std::string subject = predictor.empty() ? "the predictor" : predictor_label(predictor);
  Figure figure = named(
      "incidence", "Reaching the goal, by quartile of " + subject, h1_incidence_curve.synthetic);
  figure.caption =
      "Cumulative incidence of egress (Aalen-Johansen, failure competing) with 95 % intervals; Q1 "
      "has the lowest values. Below: trials at risk.";
  figure.key = {"quartile", distinct(h1_incidence_curve, "strata")};
  figure.data = figure_table("incidence",
                             {"panel", "quartile", "at_risk"},
                             {"time_s", "incidence", "incidence_low", "incidence_high"});
  double last = 0.0;
  for (std::size_t row = 0; row < h1_incidence_curve.rows.size(); ++row) {
    last = std::fmax(last, number_at(h1_incidence_curve, row, "time"));
  }
  if (!(last > 0.0)) {
    return std::nullopt;
  }
  const double step = round_step(last, kRiskTimes);
  std::vector<double> times;
  double next = 0.0;
  while (next <= last) {
    times.push_back(next);
    next += step;
  }
  Axis time = axis("time", "s");
  time.low = -0.07 * last;
  time.high = 1.03 * last;
  time.ticks = times;
  std::vector<Panel> curves;
  std::vector<Panel> risks;
  for (const std::string& panel : distinct(h1_incidence_curve, "panel")) {
    for (const std::string& group : figure.key.classes) {
      add_incidence_rows(
          panel, group, incidence_of(h1_incidence_curve, panel, group), times, figure.data);
    }
    Panel one;
    one.title = panel_title(panel);
    one.name = panel;
    one.x = time;
    one.y = share_axis("cumulative incidence of egress");
    Layer band = layer(Mark::band, "band", "time_s", "incidence_low");
    band.y2 = "incidence_high";
    band.colour = "quartile";
    Layer curve = layer(Mark::step, "curve", "time_s", "incidence");
    curve.colour = "quartile";
    curve.width = 1.8;
    one.layers = {band, curve};
    curves.push_back(one);
    Panel risk;
    risk.name = panel;
    risk.title = "at risk";
    risk.x = time;
    risk.x.hidden = true;
    risk.y.scale = AxisScale::categories;
    risk.y.categories.assign(figure.key.classes.rbegin(), figure.key.classes.rend());
    Layer number = layer(Mark::text, "risk", "time_s", "quartile");
    number.text = "at_risk";
    risk.layers = {number};
    risk.height = 0.28;
    risks.push_back(risk);
  }
  figure.columns = static_cast<int>(std::min<std::size_t>(2, curves.size()));  // Risks below.
  figure.panels = std::move(curves);
  figure.panels.insert(figure.panels.end(), risks.begin(), risks.end());
  return finished(std::move(figure));
}

}  // namespace tcert
