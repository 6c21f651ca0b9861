#pragma once
/// \file
/// A penalised logistic regression as tables, shaped as those of the plain one.

#include <statistics/logistic/firth.hpp>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// `statistic` and `p.value` are those of the penalised likelihood ratio, not Wald's.
[[nodiscard]] FitReport firth_report(const statistics::FirthFit& fit);

}  // namespace tcert
