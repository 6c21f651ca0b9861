#include <statistics/basics/quantile.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {

std::optional<double> quantile_in_place(std::span<double> sample, double p) {
  if (!(p >= 0.0 && p <= 1.0)) {
    throw std::invalid_argument("quantile: p must lie in [0, 1]");
  }
  const auto is_nan = [](double x) { return std::isnan(x); };
  if (sample.empty() || std::any_of(sample.begin(), sample.end(), is_nan)) {
    return std::nullopt;
  }

  // R counts from 1; the fraction is taken from that index, as R does, to agree to the last bit.
  const double index = 1.0 + static_cast<double>(sample.size() - 1) * p;
  const double below = std::floor(index);
  const double fraction = index - below;
  const auto nth = sample.begin() + static_cast<std::ptrdiff_t>(below) - 1;
  std::nth_element(sample.begin(), nth, sample.end());
  if (fraction == 0.0) {
    return *nth;
  }
  const double low = *nth;
  const double high = *std::min_element(nth + 1, sample.end());
  if (low == high) {
    return low;
  }
  const double value = (1.0 - fraction) * low + fraction * high;
  if (std::isnan(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<double> quantile(std::span<const double> sample, double p) {
  std::vector<double> scratch(sample.begin(), sample.end());
  return quantile_in_place(scratch, p);
}

std::optional<double> median(std::span<const double> sample) { return quantile(sample, 0.5); }

}  // namespace tcert::statistics
