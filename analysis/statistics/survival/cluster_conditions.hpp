#pragma once
/// \file
/// Whether a curve has the weights and clusters that it needs, and a group clusters enough for a
/// robust variance.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/basics/condition.hpp>
#include <string>
#include <table/factor.hpp>

namespace tcert::statistics {

/// \throws std::invalid_argument, which begins with `what`, if a weight is negative or not finite,
/// or a cluster is missing. No weights and no clusters are right.
void require_weights_and_clusters(const std::string& what,
                                  std::span<const double> weights,
                                  const table::Factor* cluster);

/// Distinct clusters among `rows`. O(rows log rows).
[[nodiscard]] std::size_t count_clusters(const table::Factor& cluster,
                                         std::span<const std::uint32_t> rows);

/// Adds one_cluster (a warning: no variance) or few_clusters (a note) where they hold.
void add_group_conditions(std::size_t clusters, const std::string& group, Conditions& conditions);

}  // namespace tcert::statistics
