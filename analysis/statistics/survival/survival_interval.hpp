#pragma once
/// \file
/// Confidence intervals of a probability that changes with time, on the scales that survival curves
/// use. Checked against R's `survfit(conf.type =)`.

#include <cstdint>
#include <statistics/basics/interval.hpp>

namespace tcert::statistics {

/// The scale on which the interval is symmetric; R's name of it is the enumerator with a hyphen.
enum class IntervalScale : std::uint8_t { log, log_log, plain, logit, arcsin };

/// Interval of a probability `p` with standard error `log_std_error` of log p. Ends are in [0, 1];
/// both are NaN where the scale has none (p = 0; on log_log, logit and arcsin p = 1 as well).
/// \throws std::invalid_argument if `level` is not in (0, 1).
[[nodiscard]] Interval survival_interval(double p,
                                         double log_std_error,
                                         IntervalScale scale = IntervalScale::log,
                                         double level = 0.95);

}  // namespace tcert::statistics
