#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "analysis/study/early/success_by_quantile.hpp"
#include "reports/figure/early_figures.hpp"
#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {

std::string early_trials_text(const study::EarlyTrials& trials) {
  return trials.kind == study::H1PanelKind::landmark
             ? fmt::format(
                   "Landmark panel: TC_early of the first {} s, {} trials that still ran and moved "
                   "then.",
                   significant(trials.landmark_s, 4),
                   trials.size())
             : fmt::format(
                   "{} trials; of those that end inside the early window TC_early holds the "
                   "outcome.",
                   trials.size());
}

std::optional<Figure> success_by_quantile_figure(const study::EarlyTrials& trials,
                                                 const std::optional<SyntheticLabel>& synthetic) {
  const std::vector<study::QuantileGroup> groups =
      study::success_by_quantile(trials, study::quantile_groups(trials.size()));
  if (groups.size() < 2) {
    return std::nullopt;
  }
  Figure figure = named("success_by_quantile", "Success rate by quantile of TC_early", synthetic);
  figure.caption = fmt::format(
      "Trials in {} equal parts by the early certificate TC_early, in metres of room. Across: from "
      "the least to the largest value of the part; up: share of successes with Wilson's 95 % "
      "interval, trials taken as independent. Dashed: all trials. {}",
      groups.size(),
      early_trials_text(trials));
  figure.data =
      figure_table(figure.name,
                   {},
                   {"tc_early_m", "low_m", "high_m", "share", "share_low", "share_high", "trials"});
  Panel one;
  Extent across;
  std::size_t successes = 0;
  double least = 1.0;
  for (const study::QuantileGroup& group : groups) {
    successes += group.successes;
    least = std::min(least, group.interval.low);
    across.add(group.low_m);
    across.add(group.high_m);
    add_figure_row(figure.data,
                   "group",
                   {},
                   {std::midpoint(group.low_m, group.high_m),
                    group.low_m,
                    group.high_m,
                    group.share,
                    group.interval.low,
                    group.interval.high,
                    static_cast<double>(group.trials)});
  }
  one.x = axis("TC_early", "m");
  one.y = axis("share of successes");
  across.apply(one.x);
  one.y.low = std::max(0.0, std::floor(least * 10.0) / 10.0);
  one.y.high = 1.01;
  one.references = {
      {false, static_cast<double>(successes) / static_cast<double>(trials.size()), true}};
  Layer width = range_x("group", "low_m", "high_m", "share");
  width.tone = Tone::muted;
  Layer point = layer(Mark::point, "group", "tc_early_m", "share");
  point.size = 1.4;
  one.layers = {width, range_y("group", "tc_early_m", "share_low", "share_high"), point};
  figure.panels = {std::move(one)};
  return finished(std::move(figure));
}

}  // namespace tcert
