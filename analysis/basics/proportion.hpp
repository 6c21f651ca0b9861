#pragma once
/// \file
/// Intervals of a binomial proportion. Checked against R's `prop.test(correct = FALSE)` and
/// `binom.test`.

#include <cstddef>

#include "analysis/basics/interval.hpp"

namespace tcert {

/// Wilson's score interval of `successes` out of `trials`, within [0, 1].
/// \throws std::invalid_argument unless 0 <= successes <= trials, trials > 0 and 0 < level < 1.
[[nodiscard]] Interval wilson_interval(std::size_t successes, std::size_t trials, double level);

/// The exact two-sided interval of Clopper and Pearson, (1 - level) / 2 beyond each end.
/// \throws std::invalid_argument as `wilson_interval`.
[[nodiscard]] Interval clopper_pearson_interval(std::size_t successes,
                                                std::size_t trials,
                                                double level);

/// The exact one-sided upper bound: 1 - level beyond it; 1 if all are successes.
/// \throws std::invalid_argument as `wilson_interval`.
[[nodiscard]] double clopper_pearson_upper(std::size_t successes, std::size_t trials, double level);

}  // namespace tcert
