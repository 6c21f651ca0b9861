#include "analysis/study/rays/ray_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <statistics/calibration/conformal.hpp>
#include <table/random.hpp>
#include <utility>

namespace tcert::study {
namespace {

constexpr std::uint32_t kDayOrder = 0x5249;  // of this draw alone
constexpr double kUnlucky = 0.05;

/// True of the days, by their index, that the bound is from.
std::vector<char> deal_days(std::size_t days, std::size_t held_back, std::uint64_t seed) {
  std::vector<std::size_t> order(days);
  std::iota(order.begin(), order.end(), std::size_t{0});
  table::RandomStream random(seed, kDayOrder, 0);
  for (std::size_t left = days; left > 1; --left) {
    std::swap(order[left - 1], order[random.below(static_cast<std::uint32_t>(left))]);
  }
  std::vector<char> held(days, 0);
  for (std::size_t i = days - held_back; i < days; ++i) {
    held[order[i]] = 1;
  }
  return held;
}

/// Empty if a ray has no pair on the days that are not held back.
std::vector<RayCurve> curves_of(const RayPairs& pairs,
                                const std::vector<char>& held,
                                std::size_t most_knots,
                                std::string& problem) {
  std::vector<std::vector<double>> bends(pairs.rays.size());
  std::vector<std::vector<double>> clearances(pairs.rays.size());
  for (const RayPair& pair : pairs.pairs) {
    if (held[pair.day] == 0) {
      bends[pair.ray].push_back(pair.bend_rad);
      clearances[pair.ray].push_back(pair.clearance_m);
    }
  }
  std::vector<RayCurve> curves;
  for (std::size_t ray = 0; ray < pairs.rays.size(); ++ray) {
    if (bends[ray].empty()) {
      problem = fmt::format(
          "ray '{}' has no pair on the days that curves are fitted to; measure it on more days, "
          "leave it out, or draw others with --seed",
          pairs.rays[ray]);
      return {};
    }
    curves.push_back(fit_ray_curve(bends[ray], clearances[ray], most_knots));
  }
  return curves;
}

std::vector<DayScore> scores_of(const RayPairs& pairs,
                                const std::vector<char>& held,
                                const std::vector<RayCurve>& curves) {
  std::vector<DayScore> by_day(pairs.days.size());
  for (DayScore& day : by_day) {
    day.score_m = -std::numeric_limits<double>::infinity();
  }
  for (const RayPair& pair : pairs.pairs) {
    DayScore& day = by_day[pair.day];
    ++day.pairs;
    const double over =
        calibrated_clearance(curves[pair.ray].calibration, pair.bend_rad) - pair.clearance_m;
    if (over > day.score_m) {
      day.score_m = over;
      day.ray = pair.ray;
      day.bend_rad = pair.bend_rad;
      day.clearance_m = pair.clearance_m;
    }
  }
  std::vector<DayScore> scores;
  for (std::size_t day = 0; day < by_day.size(); ++day) {
    if (held[day] != 0) {
      scores.push_back(by_day[day]);
      scores.back().day = pairs.days[day];
    }
  }
  std::ranges::stable_sort(scores, {}, &DayScore::score_m);
  return scores;
}

RayBound bound_of(std::vector<DayScore> days, double alpha) {
  RayBound bound;
  bound.days = std::move(days);
  const std::size_t n = bound.days.size();
  bound.rank = statistics::conformal_rank(n, alpha).value();
  bound.quantile_m = bound.days[bound.rank - 1].score_m;
  bound.coverage = static_cast<double>(bound.rank) / static_cast<double>(n + 1);
  bound.coverage_low = statistics::conformal_coverage_quantile(n, bound.rank, kUnlucky);
  return bound;
}

/// How the bound lies to the pairs that it is from.
void add_slack(const RayPairs& pairs,
               const std::vector<char>& held,
               const std::vector<Calibration>& usable,
               RayBound& bound) {
  std::vector<double> slack;
  std::size_t above = 0;
  for (const RayPair& pair : pairs.pairs) {
    if (held[pair.day] != 0) {
      slack.push_back(pair.clearance_m - calibrated_clearance(usable[pair.ray], pair.bend_rad));
      above += slack.back() >= 0.0 ? 1 : 0;
    }
  }
  bound.pairs = slack.size();
  bound.pairs_above = static_cast<double>(above) / static_cast<double>(slack.size());
  const auto middle = slack.begin() + static_cast<std::ptrdiff_t>(slack.size() / 2);
  std::ranges::nth_element(slack, middle);
  bound.median_slack_m = *middle;
}

std::string too_few_days(std::size_t days, double alpha) {
  std::string text =
      fmt::format("{} {}, and a bound at alpha {:g} needs {}: {} to bound and one to fit; ",
                  days,
                  days == 1 ? "day" : "days",
                  alpha,
                  statistics::least_conformal_units(alpha) + 1,
                  statistics::least_conformal_units(alpha));
  if (days > 1) {
    // Rounded up, so that what is printed is possible.
    const double possible = std::ceil(1e4 * statistics::least_conformal_alpha(days - 1)) / 1e4;
    text += fmt::format("with {} days --alpha {:g} is possible; ", days, possible);
  }
  return text + "--no-bound gives the curve alone";
}

}  // namespace

std::size_t days_of_bound(std::size_t days, double alpha) {
  const std::size_t needed = statistics::least_conformal_units(alpha);
  return needed < days ? std::max(needed, days / 2) : 0;
}

RayCalibrationResult calibrate_rays(const RayPairs& pairs, const RayCalibrationOptions& options) {
  RayCalibrationResult result;
  const std::size_t days = pairs.days.size();
  const std::size_t held_back = options.bound ? days_of_bound(days, options.alpha) : 0;
  if (options.bound && held_back == 0) {
    result.problem = too_few_days(days, options.alpha);
    return result;
  }
  const std::vector<char> held = deal_days(days, held_back, options.seed);
  RayCalibration made;
  made.curves = curves_of(pairs, held, options.most_knots, result.problem);
  if (!result.problem.empty()) {
    return result;
  }
  made.rays = pairs.rays;
  for (std::size_t day = 0; day < days; ++day) {
    if (held[day] == 0) {
      made.fitted.push_back(pairs.days[day]);
    }
  }
  if (options.bound) {
    made.bound = bound_of(scores_of(pairs, held, made.curves), options.alpha);
  }
  for (const RayCurve& curve : made.curves) {
    made.usable.push_back(made.bound ? lowered(curve.calibration, made.bound->quantile_m)
                                     : curve.calibration);
  }
  if (made.bound) {
    add_slack(pairs, held, made.usable, *made.bound);
  }
  result.calibration = std::move(made);
  return result;
}

}  // namespace tcert::study
