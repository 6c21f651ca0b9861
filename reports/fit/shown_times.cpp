#include "reports/fit/shown_times.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <statistics/basics/quantile.hpp>

namespace tcert {
namespace {

constexpr std::array kShownShares{0.1, 0.25, 0.5, 0.75, 0.9};

/// Upwards to two digits.
double rounded(double time) {
  if (!(time > 0.0)) {
    return time;
  }
  const int exponent = static_cast<int>(std::floor(std::log10(time))) - 1;
  // Powers of ten above 1 are exact, so that 0.3 is no 0.30000000000000004.
  const double unit = std::pow(10.0, std::abs(exponent));
  const double digits = std::ceil((exponent < 0 ? time * unit : time / unit) * (1.0 - 1e-12));
  return exponent < 0 ? digits / unit : digits * unit;
}

}  // namespace

std::vector<double> shown_times(const SurvivalReportOptions& options,
                                const std::vector<double>& event_times) {
  if (!options.times.empty()) {
    return options.times;
  }
  std::vector<double> times;
  for (const double share : kShownShares) {
    if (const auto time = statistics::quantile(event_times, share)) {
      const double shown = rounded(*time);
      if (shown < options.limit.value_or(std::numeric_limits<double>::infinity())) {
        times.push_back(shown);
      }
    }
  }
  if (options.limit) {
    times.push_back(*options.limit);
  }
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::string group_name(const std::string& group) { return group.empty() ? "all" : group; }

}  // namespace tcert
