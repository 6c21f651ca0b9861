#pragma once
/// \file
/// Student's t distribution, as tests and intervals of few clusters need it. Checked against R's
/// `pt` and `qt`.

#include "analysis/basics/alternative.hpp"

namespace tcert {

/// The t above which lies `tail` of the distribution: `qt(tail, df, lower.tail = FALSE)`.
/// \pre 0 < tail < 1, df > 0.
[[nodiscard]] double student_upper_quantile(double tail, double degrees_of_freedom);

/// p-value of a statistic with that distribution. \pre df > 0, t is not NaN.
[[nodiscard]] double student_p_value(double t, double degrees_of_freedom, Alternative alternative);

}  // namespace tcert
