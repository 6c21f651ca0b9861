#include <statistics/survival/cluster_conditions.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {

void require_weights_and_clusters(const std::string& what,
                                  std::span<const double> weights,
                                  const table::Factor* cluster) {
  if (!std::all_of(weights.begin(), weights.end(), [](double weight) {
        return std::isfinite(weight) && weight >= 0.0;
      })) {
    throw std::invalid_argument(what + ": a weight is negative or not finite");
  }
  if (cluster != nullptr &&
      std::any_of(cluster->codes.begin(), cluster->codes.end(), [&](std::uint32_t code) {
        return code >= cluster->levels.size();
      })) {
    throw std::invalid_argument(what + ": a cluster is missing");
  }
}

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
