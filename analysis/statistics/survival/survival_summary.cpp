// Quantiles, restricted means and numbers at risk of survival curves.

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/survival/survival_curve.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

constexpr double kTolerance = 1.4901161193847656e-08;  // sqrt of the machine epsilon, as R has it

/// Where a descending curve, 1 at time 0, reaches 1 - p. `height(k)` may be NaN.
template <typename Height>
std::optional<double> crossing(const SurvivalCurve& curve, double p, Height height) {
  const auto& points = curve.points;
  // R looks up the least value that reaches p, with and without tolerance, and halves the way
  // between the two: the middle of a flat part that lies at p.
  double reached = std::numeric_limits<double>::infinity();
  double passed = reached;
  double reached_at = 0.0;
  double passed_at = 0.0;
  double last = 0.0;
  for (const SurvivalPoint& point : points) {
    const double fallen = 1.0 - height(point);
    if (fallen >= p - kTolerance && fallen < reached) {
      reached = fallen;
      reached_at = point.time;
    }
    if (fallen >= p + kTolerance && fallen < passed) {
      passed = fallen;
      passed_at = point.time;
    }
    last = fallen;
  }
  if (std::isinf(reached)) {
    return std::nullopt;
  }
  if (std::abs(p - last) < kTolerance) {
    return 0.5 * (reached_at + points.back().time);
  }
  if (std::isinf(passed)) {
    return std::nullopt;
  }
  return 0.5 * (reached_at + passed_at);
}

}  // namespace

SurvivalQuantile survival_quantile(const SurvivalCurve& curve,
                                   double p,
                                   IntervalScale scale,
                                   double level) {
  if (!(p > 0.0 && p < 1.0)) {
    throw std::invalid_argument("survival quantile: p must be in (0, 1)");
  }
  const auto interval = [&](const SurvivalPoint& point) {
    return survival_interval(point.survival, point.log_std_error, scale, level);
  };
  SurvivalQuantile result;
  result.p = p;
  result.time = crossing(curve, p, [](const SurvivalPoint& point) { return point.survival; });
  result.low = crossing(curve, p, [&](const SurvivalPoint& point) { return interval(point).low; });
  result.high =
      crossing(curve, p, [&](const SurvivalPoint& point) { return interval(point).high; });
  return result;
}

RestrictedMean restricted_mean(const SurvivalCurve& curve, double asked) {
  const auto& points = curve.points;
  const double limit = curve.time_near(asked);
  const double origin = points.empty() ? 0.0 : std::min(0.0, points.front().time);
  std::size_t kept = 0;
  while (kept < points.size() && points[kept].time <= limit) {
    ++kept;
  }
  double later_area = 0.0;
  double variance = 0.0;
  double end = limit;
  for (std::size_t k = kept; k-- > 0;) {
    const SurvivalPoint& point = points[k];
    later_area += (end - point.time) * point.survival;
    const double left = point.at_risk - point.events;
    if (left > 0.0) {
      variance += later_area * later_area * point.events / (point.at_risk * left);
    }
    end = point.time;
  }
  return {limit, end - origin + later_area + origin, std::sqrt(variance)};
}

double common_limit(std::span<const SurvivalCurve> curves) noexcept {
  double limit = 0.0;
  for (const SurvivalCurve& curve : curves) {
    limit = std::max(limit, curve.points.empty() ? 0.0 : curve.points.back().time);
  }
  return limit;
}

std::vector<std::vector<std::size_t>> numbers_at_risk(const SurvivalOutcome& outcome,
                                                      const table::Factor* groups,
                                                      std::span<const double> asked) {
  const std::size_t n = outcome.rows();
  if ((outcome.left_truncated() && outcome.start.size() != n) ||
      (groups != nullptr && groups->rows() != n)) {
    throw std::invalid_argument("numbers at risk: columns of different length");
  }
  std::vector<double> stops = outcome.stop;
  std::sort(stops.begin(), stops.end());
  std::vector<double> times;
  for (const double time : asked) {
    times.push_back(step_time(stops, time, [](double stop) { return stop; }));
  }
  std::vector<double> sorted = times;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t count = groups == nullptr ? 1 : groups->levels.size();
  // A row is at risk at the sorted times after its start up to its stop; unsigned numbers wrap.
  std::vector<std::vector<std::size_t>> change(count,
                                               std::vector<std::size_t>(times.size() + 1, 0));
  const auto after = [&](double time) {
    return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), time) -
                                    sorted.begin());
  };
  for (std::size_t row = 0; row < n; ++row) {
    const std::size_t g = groups == nullptr ? 0 : groups->codes[row];
    if (g >= count) {
      throw std::invalid_argument("numbers at risk: a group is missing");
    }
    ++change[g][outcome.left_truncated() ? after(outcome.start[row]) : 0];
    --change[g][after(outcome.stop[row])];
  }
  std::vector<std::vector<std::size_t>> result(count, std::vector<std::size_t>(times.size(), 0));
  for (std::size_t g = 0; g < count; ++g) {
    std::size_t at_risk = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      at_risk += change[g][k];
      change[g][k] = at_risk;
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
      const auto place = std::lower_bound(sorted.begin(), sorted.end(), times[k]) - sorted.begin();
      result[g][k] = change[g][static_cast<std::size_t>(place)];
    }
  }
  return result;
}

}  // namespace tcert::statistics
