#pragma once
/// \file
/// A logistic mixed model as tables, with broom.mixed's column names.

#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/glmm_profile.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// `profile` and `dropped` are empty if they were not asked for.
[[nodiscard]] FitReport glmm_report(const statistics::GlmmFit& fit,
                                    const statistics::GlmmProfile& profile,
                                    const std::vector<statistics::DroppedTerm>& dropped);

}  // namespace tcert
