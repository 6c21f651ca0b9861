#pragma once
/// \file
/// At which times curves are shown.

#include <string>
#include <vector>

#include "reports/fit/survival_report.hpp"

namespace tcert {

/// The times that were asked for, or rounded quantiles of the event times up to the limit: one long
/// row then does not leave the others in the first row of a table.
[[nodiscard]] std::vector<double> shown_times(const SurvivalReportOptions& options,
                                              const std::vector<double>& event_times);

/// What a table calls a group; "all" where there are none.
[[nodiscard]] std::string group_name(const std::string& group);

}  // namespace tcert
