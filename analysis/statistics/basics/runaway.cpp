#include <statistics/basics/runaway.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <statistics/basics/quantile.hpp>

namespace tcert::statistics {

double typical_spread(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double low = *least;
  const double high = *most;
  // Of two values the distance, whatever their shares.
  if (std::all_of(values.begin(), values.end(), [&](double x) { return x == low || x == high; })) {
    return high - low;
  }
  constexpr double kNormalRange = 1.349;
  const double upper = quantile_in_place(values, 0.75).value();
  const double range = upper - quantile_in_place(values, 0.25).value();
  if (range > 0.0) {
    return range / kNormalRange;
  }
  const auto middle = [](std::vector<double>& sample) {
    const auto nth = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), nth, sample.end());
    return *nth;
  };
  const double median = middle(values);
  std::vector<double> distances;
  for (const double value : values) {
    if (value != median) {
      distances.push_back(std::abs(value - median));
    }
  }
  return middle(distances);
}

bool may_have_run_away(const SpreadRatio& ratio_of_range) noexcept {
  return std::abs(ratio_of_range.log_ratio) > kCertainLogRatio ||
         ratio_of_range.error > kLargestLogError;
}

bool has_run_away(const SpreadRatio& ratio, double trials) noexcept {
  constexpr double kManyErrors = 5.0;
  const double size = std::abs(ratio.log_ratio);
  const double squared = ratio.error_without_effect * ratio.error_without_effect;
  const bool flat = ratio.error * ratio.error > trials * squared;
  return (size > kCertainLogRatio && size > kManyErrors * ratio.error_without_effect) ||
         (flat && ratio.error > kLargestLogError);
}

}  // namespace tcert::statistics
