#pragma once
/// \file
/// What counts as an event or a success, said in a fit's report.

#include <statistics/model/formula.hpp>
#include <statistics/model/model_frame.hpp>

#include "reports/fit/fit_report.hpp"

namespace tcert::cli {

/// Puts the outcome's name into a title 'log odds of success'; says which of two texts is 1, in the
/// settings event_level and reference_level and in a note.
void name_outcome(const statistics::Formula& formula,
                  const statistics::ModelFrame& frame,
                  FitReport& report);

}  // namespace tcert::cli
