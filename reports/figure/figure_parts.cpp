#include "reports/figure/figure_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "reports/figure/figure_rows.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

/// Labels of ticks beside each other, so that none touches the next one.
int ticks_across(const Figure& figure) { return figure.columns > 1 ? 5 : 8; }
int ticks_up(const Panel& panel) { return std::clamp(static_cast<int>(7.0 * panel.height), 2, 8); }

void give_ticks(Axis& axis, int most) {
  if (axis.scale == AxisScale::linear && axis.ticks.empty() && axis.low && axis.high) {
    axis.ticks = round_ticks(*axis.low, *axis.high, most);
  }
}

bool has_data(const Figure& figure, const Panel& panel) {
  return std::any_of(panel.layers.begin(), panel.layers.end(), [&](const Layer& one) {
    return !one.guide && !drawn_rows(figure, panel, one).empty();
  });
}

void group_rows(Figure& figure) {
  std::map<std::string, std::size_t> order;
  std::vector<std::pair<std::size_t, std::size_t>> rows;  // Rank of the series, row.
  const std::vector<std::string> names = series_names(figure);
  for (std::size_t row = 0; row < names.size(); ++row) {
    rows.emplace_back(order.emplace(names[row], order.size()).first->second, row);
  }
  std::sort(rows.begin(), rows.end());
  std::vector<std::vector<TableCell>> grouped;
  grouped.reserve(rows.size());
  for (const auto& [rank, row] : rows) {
    grouped.push_back(std::move(figure.data.rows[row]));
  }
  figure.data.rows = std::move(grouped);
}

}  // namespace

void Extent::add(double value) noexcept {
  if (std::isfinite(value)) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
}

void Extent::apply(Axis& axis, double room) const {
  if (low <= high) {
    const double span = high - low;
    const double margin = span > 0.0 ? room * span : std::max(0.05 * std::abs(high), 0.01);
    axis.low = low - margin;
    axis.high = high + margin;
  }
}

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

Layer guide(const char* part, const char* x, const char* y) {
  Layer one = layer(Mark::line, part, x, y);
  one.guide = true;
  one.tone = Tone::muted;
  one.width = 1.2;
  return one;
}

Axis axis(const std::string& title, const std::string& unit) {
  Axis one;
  one.title = title;
  one.unit = unit;
  return one;
}

Axis share_axis(const std::string& title) {
  Axis one = axis(title);
  one.low = 0.0;
  one.high = 1.0;
  one.ticks = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
  return one;
}

Panel interval_panel(const char* part,
                     const std::string& value,
                     const char* names,
                     const std::vector<std::string>& from_the_top) {
  Panel one;
  one.y.scale = AxisScale::categories;
  one.y.categories.assign(from_the_top.rbegin(), from_the_top.rend());
  Layer point = layer(Mark::point, part, value.c_str(), names);
  point.size = 1.4;
  one.layers = {range_x(part, (value + "_low").c_str(), (value + "_high").c_str(), names), point};
  return one;
}

std::string panel_title(const std::string& panel) {
  return panel == "paper"      ? "Paper: early window, all trials"
         : panel == "landmark" ? "Landmark: first seconds, trials still running"
                               : "";
}

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

std::vector<std::string> predictor_labels(const std::vector<std::string>& rows) {
  std::vector<std::string> labels;
  for (const std::string& row : rows) {
    const std::string label = predictor_label(row);
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) {
      labels.push_back(label);
    }
  }
  return labels;
}

std::optional<Figure> finished(Figure figure) {
  std::erase_if(figure.panels, [&](const Panel& panel) { return !has_data(figure, panel); });
  if (figure.panels.empty()) {
    return std::nullopt;
  }
  make_plain(figure);
  group_rows(figure);
  figure.columns = std::min(figure.columns, static_cast<int>(figure.panels.size()));
  for (Panel& panel : figure.panels) {
    give_ticks(panel.x, ticks_across(figure));
    give_ticks(panel.y, ticks_up(panel));
  }
  if (figure.gradient) {
    figure.gradient->ticks = round_ticks(figure.gradient->low, figure.gradient->high, 5);
  }
  return figure;
}

}  // namespace tcert
