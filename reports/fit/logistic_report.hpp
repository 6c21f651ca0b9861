#pragma once
/// \file
/// A logistic regression as tables, with broom's column names.

#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <statistics/logistic/logistic_profile.hpp>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// `profiles` holds the limits of each coefficient, or is empty if none was asked for. With a
/// robust variance there is no table of likelihood-ratio tests: they take the rows to be
/// independent. `inferences` is of every coefficient where there are clusters.
[[nodiscard]] FitReport logistic_report(const statistics::LogisticFit& fit,
                                        const std::vector<statistics::ProfileLimits>& profiles,
                                        const std::vector<statistics::DroppedTerm>& dropped,
                                        const statistics::ClusterInferences& inferences);

}  // namespace tcert
