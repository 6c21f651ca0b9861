#include "analysis/survival/cluster_conditions.hpp"

#include <algorithm>
#include <vector>

namespace tcert {
namespace {

constexpr std::size_t kFewClusters = 30;

}  // namespace

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
  const std::string of = group.empty() ? "" : group + ": ";
  if (clusters == 1) {
    conditions.push_back(
        {ConditionKind::one_cluster, ConditionSeverity::warning, "", of + "no robust variance"});
  } else if (clusters > 1 && clusters < kFewClusters) {
    conditions.push_back({ConditionKind::few_clusters,
                          ConditionSeverity::note,
                          "",
                          of + std::to_string(clusters) + " clusters"});
  }
}

}  // namespace tcert
