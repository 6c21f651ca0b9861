#include <statistics/resampling/jackknife.hpp>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void leave_out_by_kernel(const Statistic& statistic,
                         const ResamplingPlan& plan,
                         std::span<std::vector<double>> out) {
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, plan.units(), 16), [&](const Range& range) {
    const StatisticKernel kernel = statistic.make_kernel();
    std::vector<std::uint32_t> multiplicity(plan.rows());
    std::vector<double> values(statistic.values);
    for (std::size_t unit = range.begin(); unit < range.end(); ++unit) {
      for (std::size_t row = 0; row < plan.rows(); ++row) {
        multiplicity[row] = plan.unit_of(row) == unit ? 0 : 1;
      }
      kernel(multiplicity, values);
      for (std::size_t value = 0; value < values.size(); ++value) {
        out[value][unit] = values[value];
      }
    }
  });
}

}  // namespace

void leave_one_out(const Statistic& statistic,
                   const ResamplingPlan& plan,
                   std::span<std::vector<double>> out) {
  if (statistic.leave_one_out) {
    statistic.leave_one_out(plan, out);
  } else {
    leave_out_by_kernel(statistic, plan, out);
  }
}

std::vector<std::vector<double>> leave_one_out(const Statistic& statistic,
                                               const ResamplingPlan& plan) {
  if (statistic.rows != plan.rows()) {
    throw std::invalid_argument("jackknife: the statistic and the plan are of different rows");
  }
  std::vector<std::vector<double>> out(statistic.values, std::vector<double>(plan.units()));
  leave_one_out(statistic, plan, out);
  return out;
}

std::vector<double> jackknife_influence(const ResamplingPlan& plan,
                                        double observed,
                                        std::span<const double> left_out,
                                        bool centred) {
  if (left_out.size() != plan.units()) {
    throw std::invalid_argument("jackknife: one value for each unit is needed");
  }
  std::vector<double> influence(plan.units());
  std::vector<double> sum(plan.strata(), 0.0);
  for (std::size_t unit = 0; unit < influence.size(); ++unit) {
    influence[unit] =
        (static_cast<double>(plan.stratum_size(unit)) - 1.0) * (observed - left_out[unit]);
    sum[plan.stratum_of(unit)] += influence[unit];
  }
  if (centred) {
    for (std::size_t unit = 0; unit < influence.size(); ++unit) {
      influence[unit] -= sum[plan.stratum_of(unit)] / static_cast<double>(plan.stratum_size(unit));
    }
  }
  return influence;
}

std::optional<double> acceleration(std::span<const double> influence) {
  double squares = 0.0;
  double cubes = 0.0;
  for (const double value : influence) {
    squares += value * value;
    cubes += value * value * value;
  }
  const double a = cubes / (6.0 * std::pow(squares, 1.5));
  return std::isfinite(a) ? std::optional(a) : std::nullopt;
}

}  // namespace tcert::statistics
