#pragma once
/// \file
/// --cause: which of several end points each row of a survival outcome had.

#include <statistics/basics/condition.hpp>
#include <statistics/survival/cumulative_incidence.hpp>

#include "cli/runs/fit/fit_input.hpp"

namespace tcert::cli {

/// The cause of each row, 0 if it is censored. Events without a cause are no censored rows: they
/// leave the frame, counted.
[[nodiscard]] statistics::CompetingOutcome competing_outcome(const FitInput& from,
                                                             statistics::Conditions& conditions);

}  // namespace tcert::cli
