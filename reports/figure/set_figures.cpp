#include "reports/figure/set_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "analysis/basics/quantile.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Least and largest of finite values, with a little room.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  void apply(Axis& axis, double room = 0.05) const {
    if (low <= high) {
      const double margin = std::max(room * (high - low), 1e-6);
      axis.low = low - margin;
      axis.high = high + margin;
    }
  }
};

Figure named(const std::string& name,
             const std::string& title,
             const std::optional<SyntheticLabel>& synthetic) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.synthetic = synthetic;
  return figure;
}

Layer layer(Mark mark, const char* part, const char* x, const char* y) {
  Layer one;
  one.mark = mark;
  one.part = part;
  one.x = x;
  one.y = y;
  return one;
}

Layer range_x(const char* part, const char* low, const char* high, const char* y) {
  Layer one = layer(Mark::range_x, part, low, y);
  one.x2 = high;
  return one;
}

Layer range_y(const char* part, const char* x, const char* low, const char* high) {
  Layer one = layer(Mark::range_y, part, x, low);
  one.y2 = high;
  return one;
}

double margin_of(const Table& equality, const std::string& panel, const std::string& quantity) {
  for (std::size_t row = 0; row < equality.rows.size(); ++row) {
    if (text_at(equality, row, "panel") == panel &&
        text_at(equality, row, "quantity") == quantity) {
      return number_at(equality, row, "margin");
    }
  }
  return kNaN;
}

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

std::vector<double> values_of_group(const DataTable& features,
                                    const std::string& column,
                                    const std::string& group) {
  std::vector<double> values;
  for (std::size_t row = 0; row < features.rows; ++row) {
    const double value = number_at(features, row, "median_speed_cmd_mps");
    if (std::isfinite(value) && text_at(features, row, column) == group) {
      values.push_back(value);
    }
  }
  return values;
}

}  // namespace

std::optional<Figure> equivalence_figure(const Table& pairs, const Table& equality) {
  if (pairs.rows.empty()) {
    return std::nullopt;
  }
  const std::string last = distinct(pairs, "panel").back();
  Figure figure = named("equivalence", "Is it as good in every lighting?", pairs.synthetic);
  figure.caption =
      "Differences between lightings with 90 % intervals. Equivalent if all three lie within the "
      "dashed margins" +
      std::string(last == "landmark" ? "; landmark panel." : ".");
  figure.data = figure_table(
      "equivalence", {"panel", "pair"}, {"difference", "difference_low", "difference_high"});
  for (const std::string& quantity : distinct(pairs, "quantity")) {
    Panel one;
    one.name = quantity;
    one.x.title = "difference of " + quantity;
    Extent extent;
    std::vector<std::string> names;
    for (std::size_t row = 0; row < pairs.rows.size(); ++row) {
      if (text_at(pairs, row, "panel") != last || text_at(pairs, row, "quantity") != quantity) {
        continue;
      }
      const std::string pair =
          text_at(pairs, row, "first") + " \u2212 " + text_at(pairs, row, "second");
      const double low = number_at(pairs, row, "difference_low");
      const double high = number_at(pairs, row, "difference_high");
      names.push_back(pair);
      extent.add(low);
      extent.add(high);
      add_figure_row(
          figure.data, "pair", {quantity, pair}, {number_at(pairs, row, "difference"), low, high});
    }
    if (names.empty()) {
      continue;
    }
    one.references = {{true, 0.0, false}};
    if (const double margin = margin_of(equality, last, quantity); std::isfinite(margin)) {
      one.references.push_back({true, margin, true});
      one.references.push_back({true, -margin, true});
      extent.add(margin);
      extent.add(-margin);
    }
    extent.apply(one.x);
    one.y.scale = AxisScale::categories;
    one.y.categories.assign(names.rbegin(), names.rend());
    Layer point = layer(Mark::point, "pair", "difference", "pair");
    point.size = 1.4;
    one.layers = {range_x("pair", "difference_low", "difference_high", "pair"), point};
    one.height = 0.5;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = static_cast<int>(std::min<std::size_t>(2, figure.panels.size()));
  make_plain(figure);
  return figure.panels.empty() ? std::nullopt : std::optional(std::move(figure));
}

std::optional<Figure> pareto_figure(const Table& h3) {
  if (h3.rows.empty()) {
    return std::nullopt;
  }
  Figure figure = named("pareto", "Gain of speed against successes retained", h3.synthetic);
  figure.caption =
      "Every law and \u03b2: relative gain of the rate of advance (BCa intervals) against the "
      "share "
      "of successes retained (Wilson); \u03b2 in 1/m. Filled: on the Pareto front of its lighting. "
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
    one.x.title = "relative gain of the rate of advance";
    one.y.title = "successes retained (share)";
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
  make_plain(figure);
  return figure;
}

std::optional<Figure> cells_figure(const Table& cells,
                                   const std::string& name,
                                   const std::string& title) {
  if (cells.rows.empty()) {
    return std::nullopt;
  }
  const std::vector<std::string> panels = distinct(cells, "panel");
  const std::string last = panels.empty() ? std::string() : panels.back();
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < cells.rows.size(); ++row) {
    if (text_at(cells, row, "panel") == last && std::isfinite(number_at(cells, row, "auc"))) {
      rows.push_back(row);
    }
  }
  if (rows.empty()) {
    return std::nullopt;
  }
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return number_at(cells, a, "auc") < number_at(cells, b, "auc");
  });
  Figure figure = named(name, title, cells.synthetic);
  const bool has_full = std::any_of(rows.begin(), rows.end(), [&](std::size_t row) {
    return text_at(cells, row, "cell") == "full";
  });
  figure.caption =
      "AUC of TC_early under each cell's parameters with 95 % BCa intervals, sorted. "
      "Vertical: 0.5 (chance)" +
      std::string(has_full ? " and, dashed, the full method" : "") +
      std::string(last == "landmark" ? "; landmark panel." : ".");
  figure.key = {"", {"full method", "one change"}};
  figure.data = figure_table(name, {"cell", "kind"}, {"auc", "auc_low", "auc_high"});
  Panel one;
  Extent extent;
  extent.add(0.5);
  for (const std::size_t row : rows) {
    const std::string cell = text_at(cells, row, "cell");
    const bool full = cell == "full";
    one.y.categories.push_back(cell);
    if (full) {
      one.references.push_back({true, number_at(cells, row, "auc"), true});
    }
    extent.add(number_at(cells, row, "auc_low"));
    extent.add(number_at(cells, row, "auc_high"));
    add_figure_row(figure.data,
                   "cell",
                   {cell, full ? "full method" : "one change"},
                   {number_at(cells, row, "auc"),
                    number_at(cells, row, "auc_low"),
                    number_at(cells, row, "auc_high")});
  }
  one.references.push_back({true, 0.5, false});
  one.x.title = "AUC of TC_early";
  extent.apply(one.x);
  one.y.scale = AxisScale::categories;
  Layer range = range_x("cell", "auc_low", "auc_high", "cell");
  range.colour = "kind";
  Layer point = layer(Mark::point, "cell", "auc", "cell");
  point.colour = "kind";
  one.layers = {range, point};
  one.height = std::max(0.5, 0.052 * static_cast<double>(rows.size()));
  figure.panels = {std::move(one)};
  make_plain(figure);
  return figure;
}

std::optional<Figure> gate_figure(const Table& gate,
                                  const Table& passes,
                                  const Table& curve,
                                  const Table& calibration) {
  if (passes.rows.empty()) {
    return std::nullopt;
  }
  Figure figure = named("gate", "Chance to pass a gate by its margin", passes.synthetic);
  figure.caption =
      "Fitted chance with its pointwise 95 % interval, passes as marks at 0 and 1, five groups of "
      "like margin with Wilson's intervals, and the margin of an even chance with its profile "
      "interval.";
  figure.key = {"", {"fit", "passes", "groups of passes", "even chance"}};
  figure.data = figure_table("gate", {}, {"margin_m", "chance", "low", "high"});
  Panel one;
  one.x.title = "smallest margin of the pass";
  one.x.unit = "m";
  one.y.title = "chance to pass";
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
    add_figure_row(
        figure.data,
        "pass",
        {},
        {number_at(passes, row, "bottleneck_m"), number_at(passes, row, "success"), kNaN, kNaN});
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
  make_plain(figure);
  return figure;
}

std::optional<Figure> speed_figure(const Table& speed,
                                   const DataTable& features,
                                   const std::string& grouped_by) {
  Figure figure =
      named("speed_by_" + grouped_by, "Commanded speed by " + grouped_by, speed.synthetic);
  figure.caption =
      "Thick: middle half of the trials' medians; thin: from 5 to 95 %. Median of all control "
      "samples "
      "pooled, beside the one that the paper prints for its own trials.";
  figure.key = {"", {"pooled median", "published"}};
  figure.data = figure_table(
      figure.name, {"group"}, {"speed_mps", "p05_mps", "p25_mps", "p75_mps", "p95_mps", "trials"});
  Panel one;
  one.x.scale = AxisScale::categories;
  one.x.title = grouped_by;
  one.y.title = "commanded speed";
  one.y.unit = "m/s";
  one.y.low = 0.0;
  for (std::size_t row = 0; row < speed.rows.size(); ++row) {
    if (text_at(speed, row, "grouped_by") != grouped_by) {
      continue;
    }
    const std::string group = text_at(speed, row, "group");
    one.x.categories.push_back(group);
    const std::vector<double> values =
        values_of_group(features, grouped_by, group == "(none)" ? "" : group);
    const auto at = [&](double share) { return quantile(values, share).value_or(kNaN); };
    add_figure_row(figure.data,
                   "spread",
                   {group},
                   {kNaN, at(0.05), at(0.25), at(0.75), at(0.95), number_at(speed, row, "trials")});
    add_figure_row(figure.data,
                   "pooled",
                   {group},
                   {number_at(speed, row, "speed_mps"), kNaN, kNaN, kNaN, kNaN, kNaN});
    add_figure_row(figure.data,
                   "published",
                   {group},
                   {number_at(speed, row, "published_speed_mps"), kNaN, kNaN, kNaN, kNaN, kNaN});
  }
  if (one.x.categories.empty()) {
    return std::nullopt;
  }
  Layer thin = range_y("spread", "group", "p05_mps", "p95_mps");
  thin.tone = Tone::muted;
  thin.width = 1.0;
  Layer thick = range_y("spread", "group", "p25_mps", "p75_mps");
  thick.tone = Tone::faint;
  thick.width = 12.0;
  Layer pooled = layer(Mark::point, "pooled", "group", "speed_mps");
  pooled.label = "pooled median";
  pooled.size = 1.6;
  Layer published = layer(Mark::point, "published", "group", "speed_mps");
  published.label = "published";
  published.size = 3.0;
  published.hollow = true;
  one.layers = {thick, thin, pooled, published};
  figure.panels = {std::move(one)};
  make_plain(figure);
  return figure;
}

std::optional<Figure> truth_figure(const DataTable& features,
                                   const std::optional<SyntheticLabel>& synthetic) {
  if (features.find("truth_lower_m") == nullptr || features.find("truth_upper_m") == nullptr) {
    return std::nullopt;
  }
  Figure figure = named("truth", "The certificate against the truth", synthetic);
  figure.caption =
      "T(E; A), the best margin that any path through the known world has, as the interval that is "
      "proven, against the certificate T_t at the end of the trial. A lower bound lies on the "
      "diagonal or above it.";
  figure.key = {"", {"success", "failure"}};
  figure.data = figure_table(
      "truth", {"trial_id", "outcome"}, {"certificate_m", "truth_lower_m", "truth_upper_m"});
  Extent extent;
  for (std::size_t row = 0; row < features.rows; ++row) {
    const double certificate = number_at(features, row, "certificate_m");
    const double low = number_at(features, row, "truth_lower_m");
    const double high = number_at(features, row, "truth_upper_m");
    const double success = number_at(features, row, "success");
    if (!std::isfinite(certificate) || (!std::isfinite(low) && !std::isfinite(high))) {
      continue;
    }
    for (const double value : {certificate, low, high}) {
      extent.add(value);
    }
    add_figure_row(figure.data,
                   "trial",
                   {text_at(features, row, "trial_id"),
                    std::isnan(success) ? ""
                    : success == 1.0    ? "success"
                                        : "failure"},
                   {certificate, low, high});
  }
  if (figure.data.rows.empty()) {
    return std::nullopt;
  }
  add_figure_row(figure.data, "equal", {"", ""}, {extent.low, extent.low, kNaN});
  add_figure_row(figure.data, "equal", {"", ""}, {extent.high, extent.high, kNaN});
  Panel one;
  one.x.title = "certificate T_t";
  one.x.unit = "m";
  one.y.title = "truth T(E; A)";
  one.y.unit = "m";
  extent.apply(one.x);
  extent.apply(one.y);
  Layer equal = layer(Mark::line, "equal", "certificate_m", "truth_lower_m");
  equal.tone = Tone::muted;
  equal.width = 1.0;
  Layer range = range_y("trial", "certificate_m", "truth_lower_m", "truth_upper_m");
  range.colour = "outcome";
  range.width = 0.8;
  Layer point = layer(Mark::point, "trial", "certificate_m", "truth_lower_m");
  point.colour = "outcome";
  point.size = 0.7;
  one.layers = {equal, range, point};
  one.height = 1.4;
  figure.panels = {std::move(one)};
  make_plain(figure);
  return figure;
}

}  // namespace tcert
