#pragma once
/// \file
/// What the reports of studies of the tool itself begin with.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// A report of made data.
[[nodiscard]] FitReport study_report(std::string name, std::uint64_t seed);

/// One row of numbers.
[[nodiscard]] Table study_summary(
    const std::vector<std::pair<std::string, std::uint64_t>>& numbers);

}  // namespace tcert
