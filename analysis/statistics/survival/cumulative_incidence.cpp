#include <statistics/survival/cumulative_incidence.hpp>

#include <algorithm>
#include <limits>
#include <statistics/basics/time_order.hpp>
#include <statistics/survival/cluster_conditions.hpp>
#include <statistics/survival/incidence_walk.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {
namespace {

void check(const CompetingOutcome& outcome, const IncidenceOptions& options) {
  const std::size_t n = outcome.stop.size();
  if (outcome.cause.size() != n || (!options.weights.empty() && options.weights.size() != n) ||
      (options.groups != nullptr && options.groups->rows() != n) ||
      (options.cluster != nullptr && options.cluster->rows() != n)) {
    throw std::invalid_argument("cumulative incidence: columns of different length");
  }
  if (std::any_of(outcome.cause.begin(), outcome.cause.end(), [&](std::uint32_t cause) {
        return cause > outcome.causes.size();
      })) {
    throw std::invalid_argument("cumulative incidence: a cause is out of range");
  }
  require_weights_and_clusters("cumulative incidence", options.weights, options.cluster);
}

/// The influences of a single cluster sum to 0, which is no variance.
void forget_variances(IncidenceCurves& curves) {
  const std::vector<double> none(curves.time.size(), std::numeric_limits<double>::quiet_NaN());
  curves.event_free.std_error = none;
  for (IncidenceCurve& curve : curves.causes) {
    curve.std_error = none;
  }
}

void name_conditions(const IncidenceRows& rows, IncidenceCurves& curves) {
  if (curves.rows == 0) {
    curves.conditions.push_back(
        {ConditionKind::no_rows, ConditionSeverity::error, {}, curves.group});
  } else if (std::all_of(rows.stops.begin(), rows.stops.end(), [&](std::uint32_t row) {
               return (*rows.cause)[row] == 0;
             })) {
    curves.conditions.push_back(
        {ConditionKind::no_events, ConditionSeverity::warning, {}, curves.group});
  }
}

}  // namespace

double IncidenceCurves::time_near(double t) const noexcept {
  return step_time(time, t, [](double one) { return one; });
}

std::size_t IncidenceCurves::index_at(double t) const noexcept {
  const auto after = std::upper_bound(time.begin(), time.end(), time_near(t));
  return after == time.begin() ? time.size() : static_cast<std::size_t>(after - time.begin()) - 1;
}

std::vector<IncidenceCurves> cumulative_incidence(CompetingOutcome outcome,
                                                  const IncidenceOptions& options) {
  check(outcome, options);
  SurvivalOutcome any{std::move(outcome.start), std::move(outcome.stop), {}};
  for (const std::uint32_t cause : outcome.cause) {
    any.event.push_back(cause == 0 ? 0 : 1);
  }
  const std::size_t groups = options.groups == nullptr ? 1 : options.groups->levels.size();
  const TimeOrder order = time_order(any,
                                     options.groups == nullptr ? std::span<const std::uint32_t>{}
                                                               : std::span(options.groups->codes),
                                     groups);
  std::vector<IncidenceCurves> result(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    const IncidenceRows rows{&any, &outcome.cause, &options, order.stops_of(g), order.starts_of(g)};
    IncidenceCurves& curves = result[g];
    curves.group = options.groups == nullptr ? std::string() : options.groups->levels[g];
    curves.rows = rows.stops.size();
    curves.event_free.cause = "(event-free)";
    for (const std::string& cause : outcome.causes) {
      curves.causes.push_back({cause, {}, {}, {}});
    }
    walk_incidence(rows, curves);
    name_conditions(rows, curves);
    if (options.cluster != nullptr) {
      const std::size_t clusters = count_clusters(*options.cluster, rows.stops);
      add_group_conditions(clusters, curves.group, curves.conditions);
      if (clusters == 1) {
        forget_variances(curves);
      }
    }
  }
  return result;
}

}  // namespace tcert::statistics
