#include <statistics/survival/cluster_conditions.hpp>

#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <utility>
#include <vector>

namespace tcert::statistics {

std::size_t count_clusters(const table::Factor& cluster, std::span<const std::uint32_t> rows) {
  std::vector<std::uint32_t> codes;
  codes.reserve(rows.size());
  for (const std::uint32_t row : rows) {
    codes.push_back(cluster.codes[row]);
  }
  return count_codes(codes);
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

}  // namespace tcert::statistics
