#include <statistics/survival/cluster_conditions.hpp>

#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/few_clusters.hpp>
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

void add_group_conditions(std::size_t clusters, const std::string& group, Conditions& conditions) {
  const std::string of = group.empty() ? "" : group + ": ";
  add_cluster_conditions(clusters, of + "no robust variance", conditions, 0, group);
}

}  // namespace tcert::statistics
