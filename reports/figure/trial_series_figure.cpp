#include "reports/figure/trial_figures.hpp"

#include <table/not_a_number.hpp>

#include <array>
#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr double kSpeedWindow = 1.0;  // Seconds.

struct Line {
  const char* column;
  const char* label;
};

/// What is drawn last lies on top.
constexpr auto kMargins = std::to_array<Line>({{"margin_m", "tick margin m_t"},
                                               {"edge_margin_m", "edge margin"},
                                               {"corridor_value_m", "corridor value V_t"},
                                               {"certificate_m", "certificate T_t"}});

/// Speed over the window that ends at `row`.
double measured_speed(const table::DataTable& series,
                      const std::vector<double>& time,
                      std::size_t row) {
  double way = 0.0;
  std::size_t i = row;
  while (i > 0 && time[row] - time[i - 1] <= kSpeedWindow + 1e-9) {
    way += std::hypot(number_at(series, i, "x_m") - number_at(series, i - 1, "x_m"),
                      number_at(series, i, "y_m") - number_at(series, i - 1, "y_m"));
    --i;
  }
  const double duration = time[row] - time[i];
  return duration >= 0.5 * kSpeedWindow ? way / duration : table::kNaN;
}

/// A line over time as rows; the value is held, so rows that repeat it are left out.
void add_series(const table::DataTable& series,
                const std::vector<double>& time,
                const Line& line,
                Table& data) {
  double last = table::kNaN;
  bool first = true;
  for (std::size_t row = 0; row < series.rows; ++row) {
    const double value = number_at(series, row, line.column);
    const bool same = value == last || (std::isnan(value) && std::isnan(last));
    if (first || !same || row + 1 == series.rows) {
      if (!(first && std::isnan(value))) {
        add_figure_row(data, "margin", {"margin", line.label}, {time[row], value});
      }
    }
    first = first && std::isnan(value);
    last = value;
  }
}

Extent extent_of(const Table& data, const std::string& panel) {
  Extent extent;
  extent.add(0.0);
  for (std::size_t row = 0; row < data.rows.size(); ++row) {
    if (text_at(data, row, "panel") == panel) {
      extent.add(number_at(data, row, "value"));
    }
  }
  return extent;
}

}  // namespace

std::vector<double> trial_times(const table::DataTable& series) {
  // Of stamps since 1970 a double has no finer steps than a quarter of a microsecond.
  constexpr double kMicrosecond = 1e6;
  std::vector<double> times;
  for (std::size_t row = 0; row < series.rows; ++row) {
    const double since = number_at(series, row, "time_s") - number_at(series, 0, "time_s");
    times.push_back(std::round(since * kMicrosecond) / kMicrosecond);
  }
  return times;
}

std::optional<Figure> trial_series_figure(const TrialPicture& trial) {
  const std::vector<double> time = trial_times(trial.series);
  Figure figure = named("trial_" + trial.trial_id + "_series",
                        "Trial " + trial.trial_id + ": margins and speed",
                        trial.synthetic);
  figure.caption =
      "The tick margin recovers behind each gate; V_t keeps the narrowest place on the best way "
      "back "
      "to S; T_t is issued, at the dashed line, when G is reached by a way that is wide "
      "enough.";
  figure.data = figure_table(figure.name, {"panel", "quantity"}, {"time_s", "value"});
  figure.key.classes = {"certificate T_t",
                        "corridor value V_t",
                        "edge margin",
                        "tick margin m_t",
                        "measured speed",
                        "speed that the law allows"};
  for (const Line& line : kMargins) {
    add_series(trial.series, time, line, figure.data);
  }
  for (std::size_t row = 0; row < trial.series.rows; ++row) {
    add_figure_row(figure.data,
                   "speed",
                   {"speed", "measured speed"},
                   {time[row], measured_speed(trial.series, time, row)});
  }
  for (std::size_t row = 0; row < trial.series.rows; ++row) {
    add_figure_row(figure.data,
                   "speed",
                   {"speed", "speed that the law allows"},
                   {time[row], number_at(trial.series, row, "speed_law_mps")});
  }
  Panel margins;
  margins.name = "margin";
  margins.x = axis("time since the first tick", "s");
  margins.x.low = 0.0;
  margins.x.high = time.empty() || !(time.back() > 0.0) ? 1.0 : time.back();
  margins.y = axis("margin", "m");
  extent_of(figure.data, "margin").apply(margins.y);
  margins.references = {{false, 0.0, false}};
  if (trial.issued_s) {
    margins.references.push_back({true, *trial.issued_s, true});
  }
  Panel speed = margins;
  speed.name = "speed";
  speed.y = axis("speed", "m/s");
  extent_of(figure.data, "speed").apply(speed.y);
  speed.y.low = 0.0;
  speed.height = 0.6;
  Layer held = layer(Mark::step, "margin", "time_s", "value");
  held.colour = "quantity";
  held.width = 1.6;
  margins.layers = {held};
  Layer one = layer(Mark::line, "speed", "time_s", "value");
  one.colour = "quantity";
  one.width = 1.4;
  speed.layers = {one};
  figure.panels = {std::move(margins), std::move(speed)};
  return finished(std::move(figure));
}

}  // namespace tcert
