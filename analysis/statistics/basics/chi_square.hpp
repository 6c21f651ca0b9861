#pragma once
/// \file
/// The chi-squared distribution as tests need it.

#include <cstddef>
#include <limits>

namespace tcert::statistics {

struct ChiSquareTest {
  double statistic = 0.0;
  std::size_t df = 0;
  double p_value = std::numeric_limits<double>::quiet_NaN();  ///< NaN where nothing is tested.
};

/// The chance of a chi-squared variable above `statistic`, at least 0 and finite; `df` above 0.
[[nodiscard]] double chi_square_tail(double statistic, std::size_t df);

/// With the upper tail as p; NaN without degrees of freedom: nothing was tested. A statistic that
/// rounding has put below 0 counts as 0.
[[nodiscard]] ChiSquareTest chi_square_test(double statistic, std::size_t df);

}  // namespace tcert::statistics
