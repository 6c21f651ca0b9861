#pragma once
/// \file
/// Words and tables that logistic models with and without random effects have in common.

#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <string_view>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

/// "" for a finite coefficient, else why there is no number: "not estimable", "+infinity".
[[nodiscard]] std::string_view reason_without_estimate(statistics::CoefficientKind kind);

/// The table `drop1`. `deviance_heading` says which deviance it is.
[[nodiscard]] Table drop_table(const std::vector<statistics::DroppedTerm>& dropped,
                               std::string_view deviance_heading);

}  // namespace tcert
