#pragma once
/// \file
/// Concordances of predictors and their differences as tables.

#include <statistics/concordance/concordance.hpp>
#include <string>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

[[nodiscard]] FitReport concordance_report(const statistics::ConcordanceResult& result,
                                           double level);

}  // namespace tcert
