#pragma once
/// \file
/// Effects per standard deviation towards the better side: what H1 and H2 print of a predictor.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/cox/cox.hpp>
#include <vector>

#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Predictor `k` of the panel in standard deviations of the panel, rising towards the better side.
[[nodiscard]] Eigen::VectorXd per_sd(const H1Data& data, std::size_t k);

/// A ratio with what clusters say of its logarithm.
void take_ratio(const std::optional<double>& ratio,
                const statistics::ClusterT& by_clusters,
                H1HazardRatio& result);

/// The ratio of the first column of `cox`, clustered as `data` is, which has its rows; with the
/// strata of `data` if `stratified`. What the fit met is added to `conditions`, but for few
/// clusters, which the panel says.
[[nodiscard]] H1HazardRatio hazard_ratio(statistics::CoxData cox,
                                         const H1Data& data,
                                         double level,
                                         bool stratified,
                                         statistics::Conditions& conditions);

}  // namespace tcert::study
