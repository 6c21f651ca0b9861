#pragma once
/// \file
/// The paper's outcome model: logistic regression of success with a random intercept by cluster.

#include <Eigen/Core>
#include <span>
#include <statistics/glmm/glmm.hpp>
#include <string>
#include <vector>

#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Success of the panel's trials on an intercept and these columns (trials x columns), with a
/// random intercept by cluster. `own_units` are the columns as words are to have them; they are not
/// copied. \pre the panel has clusters.
[[nodiscard]] statistics::GlmmInput mixed_input(
    const H1Data& data,
    const Eigen::MatrixXd& columns,
    const std::vector<std::string>& names,
    const std::vector<std::span<const double>>& own_units,
    const std::string& cluster);

/// Fills `mixed` of the panel's rows: each predictor alone, the rivals together, the predictor
/// under test beside them, fitted by adaptive quadrature. Nothing where every trial is its own
/// cluster: outcome and intercept could then not be told apart.
void add_mixed_effects(const H1Data& data, const H1Options& options, H1Panel& panel);

}  // namespace tcert::study
