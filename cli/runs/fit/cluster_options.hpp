#pragma once
/// \file
/// What --inference and --left-out ask of a model with clusters.

#include <optional>
#include <statistics/clusters/cluster_inference.hpp>
#include <string>
#include <vector>

#include "cli/runs/fit/fit_input.hpp"

namespace tcert::cli {

/// \throws UsageError for another word, and for either option without clusters.
[[nodiscard]] std::optional<statistics::ClusterInference> inference_of(const FitInput& from,
                                                                       bool has_clusters);

[[nodiscard]] statistics::WildOptions wild_options(const FitRequest& request);

/// Says so where there are more clusters than are left out in turn.
void add_too_many_clusters(const std::optional<table::Factor>& cluster,
                           statistics::Conditions& conditions);

/// Adds the conditions of the inferences, and the table left_out, if it is asked for and there is
/// what it is made of: the refits of the jackknife, if that was by what is inferred.
void add_cluster_tables(const FitInput& from,
                        const statistics::ClusterInferences& inferences,
                        const std::optional<statistics::ClusteredFit>& fit,
                        const std::vector<std::string>& names,
                        const table::Factor& cluster,
                        FitReport& report);

}  // namespace tcert::cli
