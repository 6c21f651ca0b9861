#include <statistics/resampling/bootstrap.hpp>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <limits>
#include <statistics/resampling/jackknife.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {
namespace {

std::vector<double> observed_values(const Statistic& statistic) {
  std::vector<double> values(statistic.values);
  statistic.make_kernel()(std::vector<std::uint32_t>(statistic.rows, 1), values);
  return values;
}

void replicate(const Statistic& statistic,
               const ResamplingPlan& plan,
               const BootstrapOptions& options,
               std::vector<std::vector<double>>& out) {
  using Range = tbb::blocked_range<std::size_t>;
  // Coarse grains: a kernel and its memory are made for each.
  const std::size_t grain = 1 + options.replicates / 64;
  tbb::parallel_for(Range(0, options.replicates, grain), [&](const Range& range) {
    const StatisticKernel kernel = statistic.make_kernel();
    std::vector<std::uint32_t> units(plan.units());
    std::vector<std::uint32_t> multiplicity(plan.rows());
    std::vector<double> values(statistic.values);
    for (std::size_t r = range.begin(); r < range.end(); ++r) {
      plan.draw(options.seed, options.analysis, r, units, multiplicity);
      kernel(multiplicity, values);
      for (std::size_t value = 0; value < values.size(); ++value) {
        out[value][r] = values[value];
      }
      if (options.advance) {
        options.advance();
      }
    }
  });
}

}  // namespace

BootstrapResult bootstrap(const Statistic& statistic,
                          const ResamplingPlan& plan,
                          const BootstrapOptions& options) {
  if (options.replicates == 0) {
    throw std::invalid_argument("bootstrap: no replicates");
  }
  BootstrapResult result;
  result.units = plan.units();
  result.left_out = leave_one_out(statistic, plan);
  result.observed = observed_values(statistic);
  result.replicates.assign(statistic.values, std::vector<double>(options.replicates));
  replicate(statistic, plan, options, result.replicates);
  for (std::size_t value = 0; value < statistic.values; ++value) {
    result.acceleration.push_back(
        acceleration(jackknife_influence(plan, result.observed[value], result.left_out[value])));
  }
  return result;
}

BootstrapEstimate bootstrap_estimate(const BootstrapResult& result,
                                     std::size_t value,
                                     double level,
                                     BootstrapMethod method,
                                     std::optional<std::size_t> units) {
  if (value >= result.observed.size()) {
    throw std::invalid_argument("bootstrap: a value that is not there");
  }
  const BootstrapDistribution distribution =
      bootstrap_distribution(result.replicates[value], result.observed[value]);
  const bool one_unit = units && *units < 2 && method == BootstrapMethod::expanded;
  BootstrapInterval interval = one_unit ? BootstrapInterval{}
                                        : bootstrap_interval(distribution,
                                                             method,
                                                             result.acceleration[value],
                                                             level,
                                                             units.value_or(result.units));
  BootstrapEstimate estimate;
  estimate.observed = distribution.observed;
  estimate.bias = distribution.mean - distribution.observed;
  estimate.standard_error = distribution.standard_deviation;
  estimate.interval = interval.interval;
  estimate.conditions = std::move(interval.conditions);
  return estimate;
}

const std::optional<Interval>& BootstrapIntervals::of(BootstrapMethod method) const {
  switch (method) {
    case BootstrapMethod::expanded:
      return expanded;
    case BootstrapMethod::percentile:
      return percentile;
    case BootstrapMethod::bca:
      return bca;
    case BootstrapMethod::normal:
    case BootstrapMethod::basic:
      break;
  }
  throw std::invalid_argument("bootstrap: an interval that is not kept");
}

BootstrapIntervals bootstrap_intervals(const BootstrapResult& result,
                                       std::size_t value,
                                       double level,
                                       std::optional<std::size_t> units) {
  const auto by = [&](BootstrapMethod method) {
    return bootstrap_estimate(result, value, level, method, units).interval;
  };
  BootstrapEstimate bca = bootstrap_estimate(result, value, level, BootstrapMethod::bca);
  BootstrapIntervals intervals{
      by(BootstrapMethod::expanded), by(BootstrapMethod::percentile), bca.interval, std::nullopt};
  for (Condition& condition : bca.conditions) {
    const bool is_reason = condition.kind == ConditionKind::infinite_bias ||
                           condition.kind == ConditionKind::no_acceleration;
    if (is_reason && !bca.interval && intervals.percentile) {
      intervals.no_bca = std::move(condition);
    }
  }
  return intervals;
}

}  // namespace tcert::statistics
