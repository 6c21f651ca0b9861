#include "analysis/basics/runaway.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/basics/quantile.hpp"

namespace tcert {

double typical_spread(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  constexpr double kNormalRange = 1.349;
  const double range = quantile(values, 0.75).value() - quantile(values, 0.25).value();
  if (range > 0.0) {
    return range / kNormalRange;
  }
  const double median = values[values.size() / 2];
  std::vector<double> distances;
  for (const double value : values) {
    if (value != median) {
      distances.push_back(std::abs(value - median));
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances.empty() ? 0.0 : distances[distances.size() / 2];
}

bool has_run_away(const SpreadRatio& ratio, double trials) noexcept {
  constexpr double kManyErrors = 5.0;
  const double size = std::abs(ratio.log_ratio);
  const double squared = ratio.error_without_effect * ratio.error_without_effect;
  const bool flat = ratio.error * ratio.error > trials * squared;
  return (size > kCertainLogRatio && size > kManyErrors * ratio.error_without_effect) ||
         (flat && ratio.error > kLargestLogError);
}

}  // namespace tcert
