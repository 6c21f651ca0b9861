#include "reports/figure/h1_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kRiskTimes = 6;

std::string panel_title(const std::string& panel) {
  return panel == "paper"      ? "Paper: early window, all trials"
         : panel == "landmark" ? "Landmark: first seconds, trials still running"
                               : "";
}

Axis share_axis(const std::string& title) {
  Axis axis;
  axis.title = title;
  axis.low = 0.0;
  axis.high = 1.0;
  axis.ticks = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
  return axis;
}

std::vector<std::string> labels_of(const std::vector<std::string>& rows) {
  std::vector<std::string> labels;
  for (const std::string& row : rows) {
    const std::string label = predictor_label(row);
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) {
      labels.push_back(label);
    }
  }
  return labels;
}

Figure named(const char* name, const char* title, const Table& from) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.synthetic = from.synthetic;
  return figure;
}

struct PlanePoint {
  double x = 0.0;
  double y = 0.0;
};

bool straight(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y);
}

/// Corners of a curve.
std::vector<PlanePoint> corners(const std::vector<PlanePoint>& points) {
  std::vector<PlanePoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0 || i + 1 == points.size() || !straight(kept.back(), points[i], points[i + 1])) {
      kept.push_back(points[i]);
    }
  }
  return kept;
}

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
  add_figure_row(data, "curve", {panel, group, ""}, {0.0, 0.0, kNaN, kNaN});
  double low = kNaN;
  double high = kNaN;
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    const bool last = i + 1 == curve.time.size();
    if (i > 0 && curve.estimate[i] == curve.estimate[i - 1] && !last) {
      continue;
    }
    add_figure_row(
        data, "curve", {panel, group, ""}, {curve.time[i], curve.estimate[i], kNaN, kNaN});
    // The band has corners: what it was until now, and what it is from now on.
    if (std::isfinite(low)) {
      add_figure_row(data, "band", {panel, group, ""}, {curve.time[i], kNaN, low, high});
    }
    low = curve.low[i];
    high = curve.high[i];
    if (std::isfinite(low)) {
      add_figure_row(data, "band", {panel, group, ""}, {curve.time[i], kNaN, low, high});
    }
  }
  for (const double time : times) {
    add_figure_row(
        data, "risk", {panel, group, fixed(at_risk(curve, time), 0)}, {time, kNaN, kNaN, kNaN});
  }
}

/// A ratio that the forest shows: table, column, title.
struct Ratio {
  const Table* table;
  const char* column;
  const char* title;
};

}  // namespace

std::string predictor_label(const std::string& row) {
  constexpr std::string_view kAdded = "rivals + ";
  if (row.rfind(kAdded, 0) == 0) {
    return std::string(kAdded) + predictor_label(row.substr(kAdded.size()));
  }
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kLabels = {
      {{"tc_", "TC_early"},
       {"contacts_per_m", "contacts per metre"},
       {"dwell", "dwell"},
       {"bend_variance", "bend variance"}}};
  for (const auto& [column, label] : kLabels) {
    const std::string landmark = std::string(column) + (column == "tc_" ? "" : "_") + "landmark";
    if (row == landmark || row == (column == "tc_" ? "tc_early" : column)) {
      return std::string(label);
    }
  }
  return row;
}

std::optional<Figure> roc_figure(const Table& h1_roc) {
  if (h1_roc.rows.empty()) {
    return std::nullopt;
  }
  Figure figure = named("roc", "Success: ROC curves", h1_roc);
  figure.caption =
      "Share of successes called success against share of failures called success, by threshold. "
      "Models are scored on the trials of their fit. Dashed: chance.";
  figure.key.classes = labels_of(distinct(h1_roc, "predictor"));
  figure.data =
      figure_table("roc", {"panel", "predictor"}, {"false_success_share", "success_share"});
  const std::vector<std::string> panels = distinct(h1_roc, "panel");
  for (const std::string& panel : panels) {
    for (const std::string& predictor : distinct(h1_roc, "predictor")) {
      std::vector<PlanePoint> points;
      for (std::size_t row = 0; row < h1_roc.rows.size(); ++row) {
        if (text_at(h1_roc, row, "panel") == panel &&
            text_at(h1_roc, row, "predictor") == predictor) {
          points.push_back(
              {1.0 - number_at(h1_roc, row, "specificity"), number_at(h1_roc, row, "sensitivity")});
        }
      }
      for (const PlanePoint& point : corners(points)) {
        add_figure_row(
            figure.data, "curve", {panel, predictor_label(predictor)}, {point.x, point.y});
      }
    }
    add_figure_row(figure.data, "chance", {panel, ""}, {0.0, 0.0});
    add_figure_row(figure.data, "chance", {panel, ""}, {1.0, 1.0});
    Panel one;
    one.title = panel_title(panel);
    one.name = panel;
    one.x = share_axis("failures called success");
    one.y = share_axis("successes called success");
    Layer chance;
    chance.mark = Mark::line;
    chance.part = "chance";
    chance.x = "false_success_share";
    chance.y = "success_share";
    chance.tone = Tone::muted;
    chance.width = 1.0;
    Layer curve = chance;
    curve.part = "curve";
    curve.colour = "predictor";
    curve.width = 1.8;
    one.layers = {chance, curve};
    one.height = 1.15;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = static_cast<int>(std::min<std::size_t>(2, panels.size()));
  make_plain(figure);
  return figure;
}

std::optional<Figure> incidence_figure(const Table& from) {
  if (from.rows.empty()) {
    return std::nullopt;
  }
  Figure figure = named("incidence", "Reaching the goal, by quartile of TC_early", from);
  figure.caption =
      "Cumulative incidence of egress (Aalen-Johansen, failure competing) with 95 % intervals; Q1 "
      "has the lowest margins. Below: trials at risk.";
  figure.key = {"quartile", distinct(from, "strata")};
  figure.data = figure_table("incidence",
                             {"panel", "quartile", "at_risk"},
                             {"time_s", "incidence", "incidence_low", "incidence_high"});
  double last = 0.0;
  for (std::size_t row = 0; row < from.rows.size(); ++row) {
    last = std::max(last, number_at(from, row, "time"));
  }
  const double step = round_step(last, kRiskTimes);
  std::vector<double> times;
  for (double time = 0.0; time <= last; time += step) {
    times.push_back(time);
  }
  Axis time;
  time.title = "time";
  time.unit = "s";
  time.low = -0.07 * last;
  time.high = 1.03 * last;
  time.ticks = times;
  std::vector<Panel> curves;
  std::vector<Panel> risks;
  for (const std::string& panel : distinct(from, "panel")) {
    for (const std::string& group : figure.key.classes) {
      add_incidence_rows(panel, group, incidence_of(from, panel, group), times, figure.data);
    }
    Panel one;
    one.title = panel_title(panel);
    one.name = panel;
    one.x = time;
    one.y = share_axis("cumulative incidence of egress");
    Layer band;
    band.mark = Mark::band;
    band.part = "band";
    band.x = "time_s";
    band.y = "incidence_low";
    band.y2 = "incidence_high";
    band.colour = "quartile";
    Layer curve;
    curve.mark = Mark::step;
    curve.part = "curve";
    curve.x = "time_s";
    curve.y = "incidence";
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
    Layer number;
    number.mark = Mark::text;
    number.part = "risk";
    number.x = "time_s";
    number.y = "quartile";
    number.text = "at_risk";
    risk.layers = {number};
    risk.height = 0.28;
    risks.push_back(risk);
  }
  figure.columns = static_cast<int>(std::min<std::size_t>(2, curves.size()));
  figure.panels = std::move(curves);
  figure.panels.insert(figure.panels.end(), risks.begin(), risks.end());
  make_plain(figure);
  return figure;
}

std::optional<Figure> calibration_figure(const Table& from) {
  if (from.rows.empty()) {
    return std::nullopt;
  }
  Figure figure = named("calibration", "Success: out-of-fold calibration", from);
  figure.caption =
      "Observed share of successes in tenths of the predicted probability, with Wilson's "
      "intervals. "
      "Predictions by models that have not seen the trial's day. Dashed: perfect.";
  figure.key.classes = labels_of(distinct(from, "model"));
  figure.data = figure_table("calibration",
                             {"panel", "model"},
                             {"predicted", "observed", "observed_low", "observed_high", "trials"});
  double least = 1.0;
  for (std::size_t row = 0; row < from.rows.size(); ++row) {
    const double predicted = number_at(from, row, "predicted");
    const double low = number_at(from, row, "observed_low");
    least = std::min({least, predicted, low});
    add_figure_row(figure.data,
                   "bin",
                   {text_at(from, row, "panel"), predictor_label(text_at(from, row, "model"))},
                   {predicted,
                    number_at(from, row, "observed"),
                    low,
                    number_at(from, row, "observed_high"),
                    number_at(from, row, "n")});
  }
  const double low = std::max(0.0, std::floor(least * 10.0) / 10.0);
  for (const std::string& panel : distinct(from, "panel")) {
    add_figure_row(figure.data, "ideal", {panel, ""}, {low, low, kNaN, kNaN, kNaN});
    add_figure_row(figure.data, "ideal", {panel, ""}, {1.0, 1.0, kNaN, kNaN, kNaN});
    Panel one;
    one.title = panel_title(panel);
    one.name = panel;
    one.x.title = "predicted probability of success";
    one.y.title = "observed share of successes";
    one.x.low = one.y.low = low - 0.01;
    one.x.high = one.y.high = 1.01;
    Layer ideal;
    ideal.mark = Mark::line;
    ideal.part = "ideal";
    ideal.x = "predicted";
    ideal.y = "observed";
    ideal.tone = Tone::muted;
    ideal.width = 1.0;
    Layer range;
    range.mark = Mark::range_y;
    range.part = "bin";
    range.x = "predicted";
    range.y = "observed_low";
    range.y2 = "observed_high";
    range.colour = "model";
    range.width = 1.0;
    Layer line = ideal;
    line.part = "bin";
    line.colour = "model";
    Layer point = line;
    point.mark = Mark::point;
    point.size = 1.2;
    one.layers = {ideal, range, line, point};
    one.height = 1.15;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = static_cast<int>(std::min<std::size_t>(2, figure.panels.size()));
  make_plain(figure);
  return figure;
}

std::optional<Figure> forest_figure(const Table& h1_mixed, const Table& h1_time) {
  if (h1_mixed.rows.empty() && h1_time.rows.empty()) {
    return std::nullopt;
  }
  const Table& first = h1_mixed.rows.empty() ? h1_time : h1_mixed;
  const std::string panel = distinct(first, "panel").back();
  Figure figure = named("forest", "Effects per standard deviation", first);
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
    Panel one;
    one.title = ratio.title;
    one.name = ratio.title;
    one.x.title = "ratio per SD, log scale";
    one.x.scale = AxisScale::log;
    one.x.low = low / 1.08;
    one.x.high = high * 1.08;
    one.x.ticks = ratio_ticks(*one.x.low, *one.x.high);
    one.y.scale = AxisScale::categories;
    one.y.categories.assign(shown.rbegin(), shown.rend());
    one.references = {{true, 1.0, true}};
    Layer range;
    range.mark = Mark::range_x;
    range.part = "effect";
    range.x = "ratio_low";
    range.x2 = "ratio_high";
    range.y = "predictor";
    Layer point;
    point.part = "effect";
    point.x = "ratio";
    point.y = "predictor";
    point.size = 1.4;
    one.layers = {range, point};
    one.height = 0.62;
    figure.panels.push_back(std::move(one));
  }
  if (figure.panels.empty()) {
    return std::nullopt;
  }
  figure.columns = static_cast<int>(std::min<std::size_t>(2, figure.panels.size()));
  make_plain(figure);
  return figure;
}

}  // namespace tcert
