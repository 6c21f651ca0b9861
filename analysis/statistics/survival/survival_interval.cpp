#include <statistics/survival/survival_interval.hpp>

#include <cmath>
#include <numbers>
#include <statistics/basics/normal.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

/// Into [low, high], NaN kept.
double clamp(double value, double low, double high) {
  if (value < low) {
    return low;
  }
  return value > high ? high : value;
}

double square(double x) { return x * x; }

}  // namespace

Interval survival_interval(double p, double log_std_error, IntervalScale scale, double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("survival interval: level must be in (0, 1)");
  }
  const double half = normal_factor(level) * log_std_error;
  switch (scale) {
    case IntervalScale::log:
      if (p == 0.0) {
        break;
      }
      return {std::exp(std::log(p) - half), clamp(std::exp(std::log(p) + half), 0.0, 1.0), level};
    case IntervalScale::log_log: {
      if (p == 0.0 || p == 1.0) {
        break;
      }
      const double middle = std::log(-std::log(p));
      const double width = half / std::log(p);
      return {std::exp(-std::exp(middle - width)), std::exp(-std::exp(middle + width)), level};
    }
    case IntervalScale::plain:
      return {clamp(p - half * p, 0.0, 1.0), clamp(p + half * p, 0.0, 1.0), level};
    case IntervalScale::logit: {
      if (p == 0.0 || p == 1.0) {
        break;
      }
      const double middle = std::log(p / (1.0 - p));
      const double width = half * (1.0 + p / (1.0 - p));
      return {1.0 - 1.0 / (1.0 + std::exp(middle - width)),
              1.0 - 1.0 / (1.0 + std::exp(middle + width)),
              level};
    }
    case IntervalScale::arcsin: {
      if (p == 0.0 || p == 1.0) {
        break;
      }
      const double middle = std::asin(std::sqrt(p));
      const double width = 0.5 * half * std::sqrt(p / (1.0 - p));
      const double right_angle = 0.5 * std::numbers::pi;
      return {square(std::sin(clamp(middle - width, 0.0, right_angle))),
              square(std::sin(clamp(middle + width, 0.0, right_angle))),
              level};
    }
  }
  return {table::kNaN, table::kNaN, level};
}

}  // namespace tcert::statistics
