#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "analysis/study/early/auc_by_day.hpp"
#include "reports/figure/early_figures.hpp"
#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

/// More rows cannot be read.
constexpr std::size_t kMostDays = 80;
constexpr const char* kOneDay = "one day";
constexpr const char* kThinDay = "a day with fewer than 3 trials of an outcome";
constexpr const char* kAllDays = "all days together";

constexpr const char* kWithIntervals =
    "with intervals of whole days; where they differ, days differ in margin or in luck.";
constexpr const char* kWithoutIntervals = "without intervals: days or outcomes are too few.";

/// "D01: 3 of 30 failed".
std::string day_label(const std::string& name, std::size_t successes, std::size_t failures) {
  return fmt::format("{}: {} of {} failed", name, failures, successes + failures);
}

std::string few_days_text(const study::AucByDay& found) {
  const auto number = [&](auto&& is_counted) {
    return std::count_if(found.days.begin(), found.days.end(), is_counted);
  };
  const auto few = number([](const study::DayAuc& day) { return day.auc && day.is_few(); });
  const auto none = number([](const study::DayAuc& day) { return !day.auc; });
  return (few > 0 ? fmt::format(
                        " {} of {} days have fewer than {} trials of an outcome and say next to "
                        "nothing by themselves.",
                        few,
                        found.days.size(),
                        study::kFewOutcomes)
                  : "") +
         (none > 0
              ? fmt::format(
                    " {} of {} days have one outcome alone and no AUC.", none, found.days.size())
              : "");
}

Panel day_panel(const std::vector<std::string>& names) {
  Panel one;
  one.x = axis("AUC of TC_early");
  one.x.low = -0.01;
  one.x.high = 1.01;
  one.x.ticks = {0.0, 0.25, 0.5, 0.75, 1.0};
  one.y.scale = AxisScale::categories;
  one.y.categories.assign(names.rbegin(), names.rend());
  one.references = {{true, 0.5, true}};
  Layer range = range_x("day", "auc_low", "auc_high", "label");
  range.colour = "kind";
  Layer point = layer(Mark::point, "day", "auc", "label");
  point.colour = "kind";
  point.size = 1.4;
  Layer missing = layer(Mark::text, "no_auc", "at", "label");
  missing.text = "words";
  missing.tone = Tone::muted;
  one.layers = {range, point, missing};
  one.height = std::max(0.5, 0.068 * static_cast<double>(names.size()));
  return one;
}

}  // namespace

std::optional<Figure> auc_by_day_figure(const study::EarlyTrials& trials,
                                        const std::optional<SyntheticLabel>& synthetic) {
  if (!trials.has_days || trials.day.levels.size() > kMostDays) {
    return std::nullopt;
  }
  const study::AucByDay found = study::auc_by_day(trials);
  if (!found.pooled.auc) {
    return std::nullopt;
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Figure figure = named("auc_by_day", "AUC of TC_early by day", synthetic);
  figure.caption =
      "AUC: the chance that a success has the larger TC_early than a failure; dashed: 0.5, no use. "
      "By day: 95 % score intervals (Newcombe 2006, method 5), trials taken as independent. All "
      "days: pairs of trials of the same day alone, and all pairs, " +
      std::string(found.pooled.interval ? kWithIntervals : kWithoutIntervals) +
      few_days_text(found) + " " + early_trials_text(trials);
  figure.key = {"", {kOneDay, kThinDay, kAllDays}};
  figure.data = figure_table(figure.name,
                             {"label", "kind", "words"},
                             {"auc", "auc_low", "auc_high", "successes", "failures", "at"});
  std::vector<std::string> names;
  const auto add = [&](const std::string& name,
                       const char* kind,
                       const std::optional<double>& auc,
                       const std::optional<statistics::Interval>& interval,
                       std::size_t successes,
                       std::size_t failures) {
    names.push_back(day_label(name, successes, failures));
    add_figure_row(figure.data,
                   auc ? "day" : "no_auc",
                   {names.back(), kind, auc ? "" : "one outcome alone"},
                   {auc.value_or(kNone),
                    interval ? interval->low : kNone,
                    interval ? interval->high : kNone,
                    static_cast<double>(successes),
                    static_cast<double>(failures),
                    auc ? kNone : 0.2});
  };
  for (const study::DayAuc& day : found.days) {
    add(day.day,
        day.is_few() ? kThinDay : kOneDay,
        day.auc,
        day.interval,
        day.successes,
        day.failures);
  }
  const auto add_all = [&](const char* name, const auto& auc, const auto& interval) {
    add(name, kAllDays, auc, interval, found.pooled.successes, found.pooled.failures);
  };
  if (found.within) {
    add_all("same day", found.within, found.within_interval);
  }
  add_all("all pairs", found.pooled.auc, found.pooled.interval);
  figure.panels = {day_panel(names)};
  return finished(std::move(figure));
}

}  // namespace tcert
