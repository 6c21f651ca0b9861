#include <statistics/survival/censoring_curve.hpp>

#include <algorithm>

namespace tcert::statistics {

CensoringCurve::CensoringCurve(std::span<const double> stop,
                               std::span<const std::uint8_t> censored,
                               std::vector<std::size_t> rows) {
  std::sort(
      rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return stop[a] < stop[b]; });
  double value = 1.0;
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t last = first;
    std::size_t leaving = 0;
    for (; last < rows.size() && stop[rows[last]] == stop[rows[first]]; ++last) {
      leaving += censored[rows[last]];
    }
    if (leaving > 0) {
      // Those with an event at the time have left before.
      const std::size_t at_risk = rows.size() - last + leaving;
      value *= 1.0 - static_cast<double>(leaving) / static_cast<double>(at_risk);
      time_.push_back(stop[rows[first]]);
      value_.push_back(value);
    }
    first = last;
  }
}

double CensoringCurve::before(double t) const noexcept {
  const auto next = std::lower_bound(time_.begin(), time_.end(), t);
  return next == time_.begin() ? 1.0 : value_[static_cast<std::size_t>(next - time_.begin()) - 1];
}

double CensoringCurve::at(double t) const noexcept {
  const auto next = std::upper_bound(time_.begin(), time_.end(), t);
  return next == time_.begin() ? 1.0 : value_[static_cast<std::size_t>(next - time_.begin()) - 1];
}

}  // namespace tcert::statistics
