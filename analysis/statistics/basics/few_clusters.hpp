#pragma once
/// \file
/// From how many clusters on a cluster-robust variance is to be believed: the one place that says.

#include <cstddef>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <string>

namespace tcert::statistics {

/// Below so many clusters it is said that intervals tend to be too narrow.
inline constexpr std::size_t kFewClusters = 30;

/// Below so many they are not to be believed: a warning.
inline constexpr std::size_t kTooFewForSandwich = 10;

/// The same where the jackknife of whole clusters with refits stands beside them.
inline constexpr std::size_t kTooFewClusters = 6;

/// The condition few_clusters where it holds, for 2 clusters and more: a note below kFewClusters; a
/// warning below `least`, and if there are no more clusters than `coefficients`, whose
/// covariance then has no full rank (their scores add up to 0). `of` stands before the number:
/// "dark". Empty for 0 and 1 cluster: that is one_cluster.
[[nodiscard]] std::optional<Condition> few_clusters(std::size_t clusters,
                                                    std::size_t coefficients = 0,
                                                    const std::string& of = {},
                                                    std::size_t least = kTooFewForSandwich);

/// Adds one_cluster, a warning with `of_one` for its detail, or few_clusters, where they hold.
void add_cluster_conditions(std::size_t clusters,
                            std::string of_one,
                            Conditions& conditions,
                            std::size_t coefficients = 0,
                            const std::string& of = {},
                            std::size_t least = kTooFewForSandwich);

}  // namespace tcert::statistics
