#include <statistics/survival/survival_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/basics/time_order.hpp>
#include <statistics/survival/cluster_conditions.hpp>
#include <statistics/survival/curve_walk.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void check(const SurvivalOutcome& outcome, const CurveOptions& options) {
  const std::size_t n = outcome.rows();
  if ((!options.weights.empty() && options.weights.size() != n) ||
      (options.groups != nullptr && options.groups->rows() != n) ||
      (options.cluster != nullptr && options.cluster->rows() != n)) {
    throw std::invalid_argument("survival curve: columns of different length");
  }
  require_weights_and_clusters("survival curve", options.weights, options.cluster);
}

/// The influences of a single cluster sum to 0, which is no variance.
void forget_variances(SurvivalCurve& curve) {
  for (SurvivalPoint& point : curve.points) {
    point.log_std_error = std::numeric_limits<double>::quiet_NaN();
    point.hazard_std_error = std::numeric_limits<double>::quiet_NaN();
  }
}

void name_conditions(SurvivalCurve& curve) {
  if (curve.rows == 0) {
    curve.conditions.push_back({ConditionKind::no_rows, ConditionSeverity::error, {}, curve.group});
  } else if (std::none_of(curve.points.begin(), curve.points.end(), [](const auto& point) {
               return point.events > 0.0;
             })) {
    curve.conditions.push_back(
        {ConditionKind::no_events, ConditionSeverity::warning, {}, curve.group});
  }
}

}  // namespace

double SurvivalPoint::std_error() const noexcept { return survival * log_std_error; }

double SurvivalCurve::time_near(double time) const noexcept {
  return step_time(points, time, [](const SurvivalPoint& point) { return point.time; });
}

const SurvivalPoint* SurvivalCurve::at(double time) const noexcept {
  const auto after = std::upper_bound(
      points.begin(), points.end(), time_near(time), [](double value, const SurvivalPoint& point) {
        return value < point.time;
      });
  return after == points.begin() ? nullptr : &*(after - 1);
}

std::vector<SurvivalCurve> survival_curves(const SurvivalOutcome& outcome,
                                           const CurveOptions& options) {
  check(outcome, options);
  const std::size_t groups = options.groups == nullptr ? 1 : options.groups->levels.size();
  const TimeOrder order = time_order(outcome,
                                     options.groups == nullptr ? std::span<const std::uint32_t>{}
                                                               : std::span(options.groups->codes),
                                     groups);
  const bool fractional = std::any_of(options.weights.begin(),
                                      options.weights.end(),
                                      [](double weight) { return weight != std::floor(weight); });
  std::vector<SurvivalCurve> curves(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    const CurveRows rows{&outcome,
                         &options,
                         order.stops_of(g),
                         order.starts_of(g),
                         options.cluster != nullptr || fractional};
    SurvivalCurve& curve = curves[g];
    curve.group = options.groups == nullptr ? std::string() : options.groups->levels[g];
    curve.rows = rows.stops.size();
    walk_curve(rows, curve.points);
    name_conditions(curve);
    if (options.cluster != nullptr) {
      const std::size_t clusters = count_clusters(*options.cluster, rows.stops);
      add_group_conditions(clusters, curve.group, curve.conditions);
      if (clusters == 1) {
        forget_variances(curve);
      }
    }
  }
  return curves;
}

}  // namespace tcert::statistics
