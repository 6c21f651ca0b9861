#pragma once
/// \file
/// A logistic regression as tables, with broom's column names.

#include <optional>
#include <vector>

#include "analysis/logistic/logistic.hpp"
#include "analysis/logistic/logistic_drop.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// `profiles` holds one interval a coefficient, or is empty if none was asked for.
[[nodiscard]] FitReport logistic_report(const LogisticFit& fit,
                                        const std::vector<std::optional<Interval>>& profiles,
                                        const std::vector<DroppedTerm>& dropped);

}  // namespace tcert
