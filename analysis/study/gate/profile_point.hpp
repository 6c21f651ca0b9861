#pragma once
/// \file
/// Profile-likelihood set of the 50 % point of a logistic regression. Internal to even_chance.cpp.

#include <span>

#include "analysis/study/gate/even_chance.hpp"

namespace tcert::study {

/// All x0 at which twice the drop of the log-likelihood of logistic(beta (x - x0)), maximised over
/// beta, is at most the chi-squared quantile. `point` and `slope` are the estimates, `scale` about
/// the point's standard error. \pre the data are not separated.
[[nodiscard]] ConfidenceSet profile_point_set(std::span<const double> x,
                                              std::span<const std::uint8_t> success,
                                              double point,
                                              double slope,
                                              double scale,
                                              double level);

}  // namespace tcert::study
