#include <statistics/resampling/bootstrap_difference.hpp>

#include <algorithm>
#include <functional>
#include <statistics/resampling/jackknife.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

std::vector<double> minus(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference(a.size());
  std::transform(a.begin(), a.end(), b.begin(), difference.begin(), std::minus<>());
  return difference;
}

}  // namespace

BootstrapResult paired_difference(const BootstrapResult& result,
                                  const ResamplingPlan& plan,
                                  std::size_t first,
                                  std::size_t second) {
  if (std::max(first, second) >= result.observed.size()) {
    throw std::invalid_argument("bootstrap: no value of that number");
  }
  BootstrapResult difference;
  difference.units = result.units;
  difference.observed = {result.observed[first] - result.observed[second]};
  difference.replicates = {minus(result.replicates[first], result.replicates[second])};
  difference.left_out = {minus(result.left_out[first], result.left_out[second])};
  difference.acceleration = {
      acceleration(jackknife_influence(plan, difference.observed[0], difference.left_out[0]))};
  return difference;
}

}  // namespace tcert::statistics
