#include <statistics/resampling/bootstrap_difference.hpp>

#include <algorithm>
#include <statistics/resampling/jackknife.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {
namespace {

/// [value][resample] or [value][unit].
std::vector<double> sum_of(const std::vector<std::vector<double>>& values,
                           const std::vector<std::size_t>& added,
                           const std::vector<std::size_t>& taken) {
  std::vector<double> sum(values.front().size(), 0.0);
  for (const auto& [which, sign] : {std::pair(&added, 1.0), std::pair(&taken, -1.0)}) {
    for (const std::size_t value : *which) {
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += sign * values[value][i];
      }
    }
  }
  return sum;
}

}  // namespace

BootstrapResult paired_difference(const BootstrapResult& result,
                                  const ResamplingPlan& plan,
                                  const std::vector<std::size_t>& added,
                                  const std::vector<std::size_t>& taken) {
  const auto is_known = [&](std::size_t value) { return value < result.observed.size(); };
  if (result.observed.empty() || !std::all_of(added.begin(), added.end(), is_known) ||
      !std::all_of(taken.begin(), taken.end(), is_known)) {
    throw std::invalid_argument("bootstrap: no value of that number");
  }
  BootstrapResult difference;
  difference.units = result.units;
  difference.observed = {0.0};
  for (const std::size_t value : added) {
    difference.observed[0] += result.observed[value];
  }
  for (const std::size_t value : taken) {
    difference.observed[0] -= result.observed[value];
  }
  difference.replicates = {sum_of(result.replicates, added, taken)};
  difference.left_out = {sum_of(result.left_out, added, taken)};
  difference.acceleration = {
      acceleration(jackknife_influence(plan, difference.observed[0], difference.left_out[0]))};
  return difference;
}

}  // namespace tcert::statistics
