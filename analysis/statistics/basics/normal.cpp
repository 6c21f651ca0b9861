#include <statistics/basics/normal.hpp>

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace tcert::statistics {

double normal_cdf(double z) noexcept { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double normal_quantile(double p) {
  if (!(p >= 0.0 && p <= 1.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (p == 0.0 || p == 1.0) {
    return p == 0.0 ? -std::numeric_limits<double>::infinity()
                    : std::numeric_limits<double>::infinity();
  }
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * p);
}

double normal_factor(double level) { return std::numbers::sqrt2 * boost::math::erf_inv(level); }

double normal_p_value(double z, Alternative alternative) noexcept {
  switch (alternative) {
    case Alternative::less:
      return normal_cdf(z);
    case Alternative::greater:
      return normal_cdf(-z);
    case Alternative::two_sided:
      break;
  }
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

}  // namespace tcert::statistics
