#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/set_figures.hpp"

namespace tcert {
namespace {

/// Choices in `all` that are in `front` too, by what names them.
bool is_in(const Table& front, const Table& all, std::size_t row) {
  for (std::size_t i = 0; i < front.rows.size(); ++i) {
    bool same = text_at(front, i, "speed_law") == text_at(all, row, "speed_law");
    for (const char* const column : {"beta_per_m", "replan_margin_m", "guard_min_force_n"}) {
      const double a = number_at(front, i, column);
      const double b = number_at(all, row, column);
      same = same && (a == b || (std::isnan(a) && std::isnan(b)));
    }
    if (same) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<Figure> rules_figure(const Table& monitors) {
  if (monitors.rows.empty()) {
    return std::nullopt;
  }
  Figure figure = named("rules", "What rules detect, and what they cost", monitors.synthetic);
  figure.caption =
      "Left: share of unsafe episodes that each rule detects, with its 95 % interval over days; "
      "right: "
      "false alarms an hour, and the share of the way forward that is driven under an alarm.";
  figure.data = figure_table("rules", {"panel", "rule"}, {"value", "value_low", "value_high"});
  struct Shown {
    const char* column;
    const char* title;
    const char* axis;
  };
  for (const Shown& shown : {Shown{"share", "detected", "share of unsafe episodes"},
                             Shown{"false_per_hour", "false alarms", "1/h"},
                             Shown{"progress_lost", "under alarm", "share of the way forward"}}) {
    std::vector<std::string> rules;
    Extent extent;
    extent.add(0.0);
    for (std::size_t row = 0; row < monitors.rows.size(); ++row) {
      const std::string name = shown.column;
      const double value = number_at(monitors, row, name);
      if (!std::isfinite(value)) {
        continue;
      }
      const bool has_interval = name == "share";
      const double low = has_interval ? number_at(monitors, row, name + "_low") : value;
      const double high = has_interval ? number_at(monitors, row, name + "_high") : value;
      const std::string rule = text_at(monitors, row, "monitor");
      add_figure_row(figure.data, "rule", {shown.title, rule}, {value, low, high});
      rules.push_back(rule);
      extent.add(value);
      extent.add(high);
    }
    if (rules.empty()) {
      continue;
    }
    Panel one = interval_panel("rule", "value", "rule", rules);
    one.title = shown.title;
    one.name = shown.title;
    one.x = axis(shown.axis);
    extent.apply(one.x, 0.06);
    one.height = 0.62;
    figure.panels.push_back(std::move(one));
  }
  figure.columns = 3;
  return finished(std::move(figure));
}

std::optional<Figure> guards_figure(const Table& guard_choices,
                                    const Table& guard_front,
                                    const Table& guard_folds) {
  if (guard_choices.rows.empty()) {
    return std::nullopt;
  }
  Figure figure = named("guards", "Progress against unsafe dwell", guard_choices.synthetic);
  figure.caption =
      "Every choice of law, beta, epsilon and F_min, replayed along logged paths: time driven at a "
      "wall "
      "within the stopping way against the progress, as a share of the unguarded robot's. Filled: "
      "no "
      "other has more progress and less dwell. Large hollow: choices made on other days, on "
      "the days left out; large filled, where the lines meet: the unguarded robot.";
  figure.key = {"speed law", distinct(guard_choices, "speed_law")};
  figure.data = figure_table("guards", {"law"}, {"progress", "unsafe"});
  Extent progress;
  Extent unsafe;
  unsafe.add(0.0);
  const auto add = [&](const char* part, const Table& from, std::size_t row) {
    const double x = number_at(from, row, "progress_share");
    const double y = number_at(from, row, "unsafe_s_per_100m");
    add_figure_row(figure.data, part, {text_at(from, row, "speed_law")}, {x, y});
    progress.add(x);
    unsafe.add(y);
  };
  for (std::size_t row = 0; row < guard_choices.rows.size(); ++row) {
    add(is_in(guard_front, guard_choices, row) ? "front" : "behind", guard_choices, row);
  }
  for (std::size_t row = 0; row < guard_folds.rows.size(); ++row) {
    add("fold", guard_folds, row);
  }
  const double unguarded = number_at(guard_choices, 0, "unguarded_s_per_100m");
  add_figure_row(
      figure.data, "unguarded", {text_at(guard_choices, 0, "speed_law")}, {1.0, unguarded});
  progress.add(1.0);
  unsafe.add(unguarded);
  Panel one;
  one.x = axis("progress (share of the unguarded)");
  one.y = axis("unsafe dwell", "s per 100 m");
  progress.apply(one.x, 0.08);
  unsafe.apply(one.y, 0.08);
  one.references = {{true, 1.0, false}, {false, unguarded, false}};
  for (const char* part : {"behind", "front", "fold", "unguarded"}) {
    Layer point = layer(Mark::point, part, "progress", "unsafe");
    const std::string_view name = part;
    if (name == "behind" || name == "front") {
      point.colour = "law";
    }
    point.size = name == "fold" || name == "unguarded" ? 2.2 : 1.6;
    point.hollow = name == "behind" || name == "fold";
    one.layers.push_back(point);
  }
  figure.panels.push_back(std::move(one));
  return finished(std::move(figure));
}

}  // namespace tcert
