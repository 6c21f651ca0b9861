#include "reports/figure/set_figures.hpp"

#include <table/not_a_number.hpp>

#include <cmath>
#include <statistics/basics/quantile.hpp>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/paper_names.hpp"

namespace tcert {
namespace {

std::vector<double> values_of_group(const table::DataTable& features,
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

bool has_published_speeds(const Table& speed) {
  bool any = false;
  for (std::size_t row = 0; row < speed.rows.size(); ++row) {
    if (text_at(speed, row, "grouped_by") == "algorithm") {
      if (!std::isfinite(number_at(speed, row, "published_speed_mps"))) {
        return false;
      }
      any = true;
    }
  }
  return any;
}

std::optional<Figure> speed_figure(const Table& speed,
                                   const table::DataTable& features,
                                   const std::string& grouped_by) {
  Figure figure =
      named("speed_by_" + grouped_by, "Commanded speed by " + grouped_by, speed.synthetic);
  const bool is_of_paper = has_published_speeds(speed);
  figure.caption =
      "Thick: middle half of the trials' medians; thin: from 5 to 95 %. Median of all control "
      "samples pooled" +
      std::string(is_of_paper ? ", beside the one that the paper prints for its own trials."
                              : ".") +
      (is_of_paper && grouped_by == "algorithm" ? " " + paper_names_text() : "");
  figure.key = {"", {"pooled median", "published"}};
  figure.data = figure_table(
      figure.name, {"group"}, {"speed_mps", "p05_mps", "p25_mps", "p75_mps", "p95_mps", "trials"});
  Panel one;
  one.x.scale = AxisScale::categories;
  one.x.title = grouped_by;
  one.y = axis("commanded speed", "m/s");
  Extent extent;
  extent.add(0.0);
  bool measured = false;
  for (std::size_t row = 0; row < speed.rows.size(); ++row) {
    if (text_at(speed, row, "grouped_by") != grouped_by) {
      continue;
    }
    const std::string group = text_at(speed, row, "group");
    one.x.categories.push_back(group);
    const std::vector<double> values =
        values_of_group(features, grouped_by, group == "(none)" ? "" : group);
    const auto at = [&](double share) {
      return statistics::quantile(values, share).value_or(table::kNaN);
    };
    const double pooled = number_at(speed, row, "speed_mps");
    measured = measured || std::isfinite(pooled) || !values.empty();
    const double in_paper =
        is_of_paper ? number_at(speed, row, "published_speed_mps") : table::kNaN;
    for (const double value : {pooled, at(0.95), in_paper}) {
      extent.add(value);
    }
    add_figure_row(
        figure.data,
        "spread",
        {group},
        {table::kNaN, at(0.05), at(0.25), at(0.75), at(0.95), number_at(speed, row, "trials")});
    add_figure_row(figure.data,
                   "pooled",
                   {group},
                   {pooled, table::kNaN, table::kNaN, table::kNaN, table::kNaN, table::kNaN});
    add_figure_row(figure.data,
                   "published",
                   {group},
                   {in_paper, table::kNaN, table::kNaN, table::kNaN, table::kNaN, table::kNaN});
  }
  if (!measured) {
    return std::nullopt;
  }
  extent.apply(one.y);
  one.y.low = 0.0;
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
  return finished(std::move(figure));
}

}  // namespace tcert
