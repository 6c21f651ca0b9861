#pragma once
/// \file
/// What `assure monitor` prints.

#include "analysis/study/assurance/assurance.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Tables: monitors, faults, and as details episodes and alarms of every trial.
[[nodiscard]] FitReport assurance_report(const study::Assurance& assurance,
                                         const std::vector<study::AssuredTrial>& trials,
                                         const std::vector<std::string>& rules);

}  // namespace tcert
