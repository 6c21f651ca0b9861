#pragma once
/// \file
/// Profile-likelihood intervals of logistic coefficients.

#include <optional>
#include <vector>

#include "analysis/basics/interval.hpp"
#include "analysis/logistic/logistic.hpp"

namespace tcert {

/// Per column of `input` the values at which twice the drop of the log-likelihood, maximised over
/// the other coefficients, is the chi-squared quantile of `options.level`: the roots themselves, to
/// 1e-10 of the quantile, where `MASS:::confint.glm` interpolates. Empty for coefficients without a
/// finite estimate, for all of them under separation, and where the root is not found.
/// \throws std::invalid_argument as `fit_logistic`. About 8 fits per coefficient and end.
[[nodiscard]] std::vector<std::optional<Interval>> profile_intervals(
    const LogisticInput& input, const LogisticOptions& options = {});

}  // namespace tcert
