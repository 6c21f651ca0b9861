#include <statistics/basics/chi_square.hpp>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

namespace tcert::statistics {

double chi_square_tail(double statistic, std::size_t df) {
  return boost::math::gamma_q(0.5 * static_cast<double>(df), 0.5 * statistic);
}

ChiSquareTest chi_square_test(double statistic, std::size_t df) {
  ChiSquareTest test{statistic, df, std::numeric_limits<double>::quiet_NaN()};
  if (!std::isnan(statistic) && df > 0) {
    test.p_value = std::isinf(statistic) ? 0.0 : chi_square_tail(std::max(0.0, statistic), df);
  }
  return test;
}

}  // namespace tcert::statistics
