#include "analysis/chi_square.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace tcert {

ChiSquareTest chi_square_test(double statistic, std::size_t df) {
  ChiSquareTest test{statistic, df, 1.0};
  if (std::isnan(statistic)) {
    test.p_value = std::numeric_limits<double>::quiet_NaN();
  } else if (df > 0) {
    test.p_value = std::isinf(statistic) ? 0.0
                                         : boost::math::gamma_q(0.5 * static_cast<double>(df),
                                                                0.5 * std::max(0.0, statistic));
  }
  return test;
}

double two_sided_quantile(double level) {
  return std::numbers::sqrt2 * boost::math::erf_inv(level);
}

double two_sided_p(double z) { return std::erfc(std::abs(z) / std::numbers::sqrt2); }

}  // namespace tcert
