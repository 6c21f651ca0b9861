#pragma once
/// \file
/// What separated data still say of a coefficient that runs to infinity: the one finite end of its
/// profile.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_problem.hpp>

namespace tcert::statistics {

/// The value of the coefficient of `column` (of the input, kept in `problem`), which runs to `sign`
/// infinity, at which twice the drop of the log-likelihood from `supremum` is the chi-squared
/// quantile of `level`: the lower limit for +1, the upper one for -1. At each value the
/// log-likelihood is its supremum over the other coefficients, some of which may be infinite
/// themselves, so it is exact where `glm` with an offset would only approach it. Empty if the root
/// is not found. About 10 fits.
[[nodiscard]] std::optional<double> one_sided_limit(const LogisticInput& input,
                                                    const LogisticProblem& problem,
                                                    std::size_t column,
                                                    double sign,
                                                    double supremum,
                                                    const LogisticOptions& options);

}  // namespace tcert::statistics
