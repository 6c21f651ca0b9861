#include "datasets/import/stream_values.hpp"

#include <cmath>
#include <limits>
#include <tcert/tick.hpp>

#include "datasets/range_rule.hpp"

namespace tcert::recording {
namespace {

constexpr double kLengthTolerance = 0.01;

}  // namespace

double yaw_of(double x, double y, double z, double w) noexcept {
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  if (!(std::abs(length - 1.0) <= kLengthTolerance)) {
    return kMissing;
  }
  return std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
}

double value_of(const ValueSource& source, std::span<const double> columns) noexcept {
  const double value =
      source.is_quaternion() ? yaw_of(columns[0], columns[1], columns[2], columns[3]) : columns[0];
  return value * source.scale + source.add;
}

double range_of(double reading,
                const ValueSource& source,
                const NoReturn& rule,
                double reach_m,
                RangeUse& use) {
  if (std::isnan(reading)) {
    return kMissing;
  }
  ++use.readings;
  // The rule's values are as the file has them, the reading is in metres.
  const bool declared = is_no_return(rule.values, (reading - source.add) / source.scale);
  if (declared || reading == std::numeric_limits<double>::infinity()) {
    ++use.no_return;
    return reach_m;
  }
  if (reading == -std::numeric_limits<double>::infinity()) {
    return 0.0;
  }
  if (!std::isfinite(reading) || reading <= 0.0 || reading < rule.range_min_m.value_or(0.0) ||
      reading > rule.range_max_m.value_or(reading)) {
    ++use.not_ranges;
    return kMissing;
  }
  return reading;
}

}  // namespace tcert::recording
