#pragma once
/// \file
/// Concordances of predictors and their differences as tables.

#include <string>
#include <vector>

#include "analysis/concordance/concordance.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

[[nodiscard]] FitReport concordance_report(const ConcordanceResult& result, double level);

}  // namespace tcert
