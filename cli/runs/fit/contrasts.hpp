#pragma once
/// \file
/// --contrasts: all pairs of a factor's levels, of any fit with coefficients.

#include <Eigen/Core>
#include <optional>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/cox/cox.hpp>
#include <statistics/glmm/glmm.hpp>
#include <statistics/lmm/lmm.hpp>
#include <statistics/logistic/logistic.hpp>

#include "cli/runs/fit/fit_input.hpp"

namespace tcert::cli {

// Each adds the table contrasts if --contrasts is given and the fit has estimates.
// \throws statistics::FormulaError as level_means().

void add_contrasts(const FitInput& from,
                   const statistics::LogisticFit& fit,
                   const std::optional<statistics::ClusteredFit>& clustered,
                   const statistics::ClusterInferences& inferences,
                   FitReport& report);
void add_contrasts(const FitInput& from,
                   const statistics::CoxFit& fit,
                   const std::optional<statistics::ClusteredFit>& clustered,
                   const statistics::ClusterInferences& inferences,
                   FitReport& report);
void add_contrasts(const FitInput& from, const statistics::GlmmFit& fit, FitReport& report);
void add_contrasts(const FitInput& from, const statistics::LmmFit& fit, FitReport& report);

}  // namespace tcert::cli
