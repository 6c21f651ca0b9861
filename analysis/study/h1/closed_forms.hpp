#pragma once
/// \file
/// What H1 knows without resampling: clustered DeLong, the jackknife of C, hazard ratios, tests of
/// nested models.

#include "analysis/study/h1/model_scores.hpp"
#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Fills the closed forms of `panel.rows` and `panel.case_level`. O(rows log rows) but for the
/// fits.
void add_closed_forms(const H1Data& data,
                      const H1Models& models,
                      const H1Options& options,
                      H1Panel& panel);

}  // namespace tcert::study
