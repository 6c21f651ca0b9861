#pragma once
/// \file
/// The chi-squared and normal tails that tests and intervals need.

#include <cstddef>

namespace tcert {

struct ChiSquareTest {
  double statistic = 0.0;
  std::size_t df = 0;
  double p_value = 1.0;
};

/// With the upper tail as p; p is 1 without degrees of freedom. A statistic that rounding has put
/// below 0 counts as 0.
[[nodiscard]] ChiSquareTest chi_square_test(double statistic, std::size_t df);

/// Two-sided standard normal quantile: 1.96 for level 0.95. \pre level in (0, 1).
[[nodiscard]] double two_sided_quantile(double level);

/// Pr(|Z| > |z|), exact in the far tail.
[[nodiscard]] double two_sided_p(double z);

}  // namespace tcert
