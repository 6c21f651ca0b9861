#pragma once
/// \file
/// --predict and --times: what a fit says of other rows, and how good its risks are.

#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/cox/cox.hpp>
#include <statistics/logistic/logistic.hpp>

#include "cli/runs/fit/fit_input.hpp"

namespace tcert::cli {

/// Of --times. \throws UsageError unless they are above 0.
[[nodiscard]] std::vector<double> times_of(const FitRequest& request);

/// Adds the table predictions if --predict is given. \throws UsageError, NoInput, BadData,
/// statistics::FormulaError.
void add_predictions(const FitInput& from,
                     const statistics::LogisticFit& fit,
                     const statistics::ClusterInferences& inferences,
                     FitReport& report);
void add_predictions(const FitInput& from,
                     const statistics::CoxData& data,
                     const statistics::CoxFit& fit,
                     const statistics::ClusterInferences& inferences,
                     FitReport& report);

/// Adds the table scores if --times are given: of the rows of the fit themselves.
void add_time_scores(const FitInput& from,
                     const statistics::CoxData& data,
                     const statistics::CoxFit& fit,
                     FitReport& report);

}  // namespace tcert::cli
