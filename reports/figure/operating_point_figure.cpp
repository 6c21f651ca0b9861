#include <fmt/format.h>

#include <limits>
#include <utility>

#include "analysis/study/early/operating_point.hpp"
#include "reports/figure/early_figures.hpp"
#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/findings.hpp"

namespace tcert {
namespace {

constexpr double kRetention = 0.95;
constexpr std::size_t kCurvePoints = 121;
constexpr const char* kByDays =
    " 95 % intervals resample whole days; of the threshold, and of what it stops, it is chosen "
    "anew "
    "in each resample, and what is kept is kept at the threshold shown.";
constexpr const char* kByTrials =
    " 95 % intervals are Wilson's, trials taken as independent, at this threshold as if it had "
    "been "
    "chosen before.";
constexpr const char* kKept = "successes kept";
constexpr const char* kStopped = "failures stopped";

std::string operating_caption(const study::OperatingPoint& point) {
  std::string text = fmt::format(
      "What stopping every trial with a TC_early below a threshold would do. At {} m, the largest "
      "threshold that keeps {} % of the successes (dashed), it keeps {} of {} successes and stops "
      "{} of {} failures.",
      in_words(point.threshold_m, point.threshold_interval),
      significant(100.0 * kRetention, 3),
      in_words(point.kept.value, point.kept.interval),
      point.successes,
      in_words(point.stopped.value, point.stopped.interval),
      point.failures);
  return text + (point.by_days ? kByDays : kByTrials) +
         " It was chosen from the trials that it is judged on. ";
}

}  // namespace

std::optional<Figure> operating_point_figure(const study::EarlyTrials& trials,
                                             const std::optional<SyntheticLabel>& synthetic) {
  const std::optional<study::OperatingPoint> point = study::operating_point(trials, kRetention);
  if (!point) {
    return std::nullopt;
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Figure figure = named("operating_point", "Stopping early: a threshold on TC_early", synthetic);
  figure.caption = operating_caption(*point) + early_trials_text(trials);
  figure.key = {"", {kKept, kStopped}};
  figure.data =
      figure_table(figure.name, {"quantity"}, {"threshold_m", "share", "share_low", "share_high"});
  Extent across;
  const std::vector<study::OperatingCurvePoint> curve =
      study::operating_curve(trials, kCurvePoints);
  for (const bool kept : {true, false}) {
    for (const study::OperatingCurvePoint& at : curve) {
      across.add(at.threshold_m);
      add_figure_row(figure.data,
                     "curve",
                     {kept ? kKept : kStopped},
                     {at.threshold_m, kept ? at.kept : at.stopped, kNone, kNone});
    }
  }
  for (const bool kept : {true, false}) {
    const study::OperatingShare& share = kept ? point->kept : point->stopped;
    add_figure_row(figure.data,
                   "point",
                   {kept ? kKept : kStopped},
                   {point->threshold_m,
                    share.value,
                    share.interval ? share.interval->low : kNone,
                    share.interval ? share.interval->high : kNone});
  }
  Panel one;
  one.x = axis("threshold on TC_early", "m");
  one.y = share_axis("share of the outcome's trials");
  across.apply(one.x);
  one.y.high = 1.01;
  one.references = {{true, point->threshold_m, true}, {false, kRetention, false}};
  Layer line = layer(Mark::line, "curve", "threshold_m", "share");
  Layer range = range_y("point", "threshold_m", "share_low", "share_high");
  range.width = 2.0;
  Layer mark = layer(Mark::point, "point", "threshold_m", "share");
  mark.size = 1.8;
  one.layers = {line, range, mark};
  for (Layer& each : one.layers) {
    each.colour = "quantity";
  }
  figure.panels = {std::move(one)};
  return finished(std::move(figure));
}

}  // namespace tcert
