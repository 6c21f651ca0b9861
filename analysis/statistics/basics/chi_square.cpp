#include <statistics/basics/chi_square.hpp>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

namespace tcert::statistics {

ChiSquareTest chi_square_test(double statistic, std::size_t df) {
  ChiSquareTest test{statistic, df, std::numeric_limits<double>::quiet_NaN()};
  if (!std::isnan(statistic) && df > 0) {
    test.p_value = std::isinf(statistic) ? 0.0
                                         : boost::math::gamma_q(0.5 * static_cast<double>(df),
                                                                0.5 * std::max(0.0, statistic));
  }
  return test;
}

}  // namespace tcert::statistics
