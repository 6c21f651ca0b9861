#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <statistics/basics/quantile.hpp>
#include <utility>

#include "analysis/study/early/early_histogram.hpp"
#include "reports/figure/early_figures.hpp"
#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr std::array<const char*, 2> kOutcomeNames = {"success", "failure"};

/// One outcome's histogram in shares of its own trials, and its quartiles.
class OutcomeHistogram {
 public:
  OutcomeHistogram(const study::EarlyTrials& trials, bool successes)
      : name_(kOutcomeNames[successes ? 0 : 1]),
        successes_(successes),
        values_(trials.sorted_values(successes)) {}

  [[nodiscard]] std::size_t trials() const noexcept { return values_.size(); }
  [[nodiscard]] double quantile(double p) const { return *statistics::quantile(values_, p); }
  [[nodiscard]] double share(const study::HistogramBin& bin) const noexcept {
    return static_cast<double>(successes_ ? bin.successes : bin.failures) /
           static_cast<double>(values_.size());
  }

  /// The outline and what it holds; above it, at `height`, median and quartiles.
  void add_to(Table& data, const std::vector<study::HistogramBin>& bins, double height) const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const auto add = [&](const char* part, double x, double y, double to_x, double base) {
      add_figure_row(data, part, {name_}, {x, to_x, y, base});
    };
    for (const study::HistogramBin& bin : bins) {
      add("fill", bin.low_m, share(bin), kNone, 0.0);
      add("fill", bin.high_m, share(bin), kNone, 0.0);
    }
    add("outline", bins.front().low_m, 0.0, kNone, kNone);
    for (const study::HistogramBin& bin : bins) {
      add("outline", bin.low_m, share(bin), kNone, kNone);
    }
    add("outline", bins.back().high_m, 0.0, kNone, kNone);
    add("quartiles", quantile(0.25), height, quantile(0.75), kNone);
    add("median", quantile(0.5), height, kNone, kNone);
  }

 private:
  std::string name_;
  bool successes_;
  std::vector<double> values_;
};

}  // namespace

std::optional<Figure> early_by_outcome_figure(const study::EarlyTrials& trials,
                                              const std::optional<SyntheticLabel>& synthetic) {
  const OutcomeHistogram successes(trials, true);
  const OutcomeHistogram failures(trials, false);
  if (successes.trials() == 0 || failures.trials() == 0) {
    return std::nullopt;
  }
  const std::vector<study::HistogramBin> bins = study::early_histogram(trials);
  Figure figure = named("early_by_outcome", "TC_early of successes and of failures", synthetic);
  figure.caption = fmt::format(
      "Share of each outcome's own trials in bins of {} m: {} successes, median {} m; {} failures, "
      "median {} m. Above: median and middle half. {}",
      significant(bins.front().high_m - bins.front().low_m, 1),
      successes.trials(),
      fixed(successes.quantile(0.5), 3),
      failures.trials(),
      fixed(failures.quantile(0.5), 3),
      early_trials_text(trials));
  figure.key = {"", {kOutcomeNames[0], kOutcomeNames[1]}};
  figure.data = figure_table(figure.name, {"outcome"}, {"tc_early_m", "to_m", "share", "base"});
  double highest = 0.0;
  for (const study::HistogramBin& bin : bins) {
    highest = std::max({highest, successes.share(bin), failures.share(bin)});
  }
  successes.add_to(figure.data, bins, 1.1 * highest);
  failures.add_to(figure.data, bins, 1.2 * highest);
  Panel one;
  one.x = axis("TC_early", "m");
  one.y = axis("share of the outcome's trials");
  Extent across;
  across.add(bins.front().low_m);
  across.add(bins.back().high_m);
  across.apply(one.x);
  one.y.low = 0.0;
  one.y.high = 1.28 * highest;
  Layer fill = layer(Mark::band, "fill", "tc_early_m", "share");
  fill.y2 = "base";
  Layer outline = layer(Mark::step, "outline", "tc_early_m", "share");
  Layer quartiles = range_x("quartiles", "tc_early_m", "to_m", "share");
  quartiles.width = 2.0;
  Layer median = layer(Mark::point, "median", "tc_early_m", "share");
  median.size = 1.6;
  one.layers = {fill, outline, quartiles, median};
  for (Layer& each : one.layers) {
    each.colour = "outcome";
  }
  figure.panels = {std::move(one)};
  return finished(std::move(figure));
}

}  // namespace tcert
