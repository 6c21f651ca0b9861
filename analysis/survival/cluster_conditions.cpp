#include "analysis/survival/cluster_conditions.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "analysis/basics/few_clusters.hpp"

namespace tcert {

std::size_t count_clusters(const Factor& cluster, std::span<const std::uint32_t> rows) {
  std::vector<bool> seen(cluster.levels.size(), false);
  for (const std::uint32_t row : rows) {
    seen[cluster.codes[row]] = true;
  }
  return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
}

void add_cluster_conditions(std::size_t clusters,
                            const std::string& group,
                            Conditions& conditions) {
  if (clusters == 1) {
    const std::string of = group.empty() ? "" : group + ": ";
    conditions.push_back(
        {ConditionKind::one_cluster, ConditionSeverity::warning, "", of + "no robust variance"});
  } else if (auto few = few_clusters(clusters, 0, group)) {
    conditions.push_back(std::move(*few));
  }
}

}  // namespace tcert
