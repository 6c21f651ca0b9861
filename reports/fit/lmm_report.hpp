#pragma once
/// \file
/// A linear mixed model as tables, with broom.mixed's column names.

#include <optional>
#include <statistics/lmm/lmm.hpp>
#include <statistics/model/formula.hpp>
#include <string>

#include "reports/fit/fit_report.hpp"
#include "reports/fit/interval_columns.hpp"

namespace tcert {

/// "ratio" where the response is a natural logarithm, log() of one argument: exp of an effect is
/// then what the response itself is multiplied by.
[[nodiscard]] std::optional<RatioName> ratio_of_response(const statistics::Formula& formula);

/// Tables coefficients, random, ran_vals, vcov.
[[nodiscard]] FitReport lmm_report(const statistics::LmmFit& fit,
                                   const std::string& response,
                                   const std::optional<RatioName>& ratio);

}  // namespace tcert
