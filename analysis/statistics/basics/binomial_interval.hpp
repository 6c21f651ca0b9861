#pragma once
/// \file
/// Intervals of a proportion from independent trials. Checked against R's `binom.test` and
/// `prop.test(correct = FALSE)`.

#include <cstddef>
#include <optional>
#include <statistics/basics/interval.hpp>

namespace tcert::statistics {

/// Clopper and Pearson's (1934) exact interval, each tail at most (1 - level) / 2. Empty without
/// trials. \throws std::invalid_argument if successes > trials or `level` is not in (0, 1).
[[nodiscard]] std::optional<Interval> clopper_pearson(std::size_t successes,
                                                      std::size_t trials,
                                                      double level = 0.95);

/// The one-sided upper bound: the proportion is at most this with confidence `level`. 1 if every
/// trial succeeded. Errors as above.
[[nodiscard]] std::optional<double> clopper_pearson_upper(std::size_t successes,
                                                          std::size_t trials,
                                                          double level = 0.95);

/// The same of trials that count as fewer, as those of a design effect do: shares of trials, by the
/// beta distribution (Korn and Graubard 1998). Empty without trials. Errors as above.
[[nodiscard]] std::optional<double> effective_upper(double successes,
                                                    double trials,
                                                    double level = 0.95);
[[nodiscard]] std::optional<Interval> effective_wilson(double successes,
                                                       double trials,
                                                       double level = 0.95);

/// Wilson's (1927) score interval. Errors as above.
[[nodiscard]] std::optional<Interval> wilson(std::size_t successes,
                                             std::size_t trials,
                                             double level = 0.95);

}  // namespace tcert::statistics
