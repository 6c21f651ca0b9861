#pragma once
/// \file
/// The standard normal distribution, as tests and intervals need it.

#include <statistics/basics/alternative.hpp>

namespace tcert::statistics {

/// Pr(Z <= z), accurate in both tails.
[[nodiscard]] double normal_cdf(double z) noexcept;

/// The z with Pr(Z <= z) = p; infinite for 0 and 1, NaN outside.
[[nodiscard]] double normal_quantile(double p);

/// Half width of a two-sided interval in standard errors: 1.96 for level 0.95. \pre 0 < level < 1.
[[nodiscard]] double normal_factor(double level);

/// p-value of a standard normal statistic.
[[nodiscard]] double normal_p_value(double z, Alternative alternative) noexcept;

}  // namespace tcert::statistics
