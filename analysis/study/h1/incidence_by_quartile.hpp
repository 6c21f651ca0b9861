#pragma once
/// \file
/// How many trials have reached G by a time, by quartile of the predictor under test.

#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Fills `incidence` of the panel: Aalen-Johansen of {egress, failure}, trials clustered. Quartiles
/// are cut at the predictor's type-7 quantiles, so ties may make them unequal; Q1 holds the lowest
/// values. Nothing without times.
void add_incidence_by_quartile(const H1Data& data, H1Panel& panel);

}  // namespace tcert::study
