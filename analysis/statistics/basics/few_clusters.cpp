#include <statistics/basics/few_clusters.hpp>

#include <utility>

namespace tcert::statistics {

std::optional<Condition> few_clusters(std::size_t clusters,
                                      std::size_t coefficients,
                                      const std::string& of,
                                      std::size_t least) {
  const bool lacks_rank = coefficients > 0 && clusters <= coefficients;
  if (clusters < 2 || (clusters >= kFewClusters && !lacks_rank)) {
    return std::nullopt;
  }
  const bool too_few = clusters < least;
  std::string detail = of.empty() ? "" : of + ": ";
  detail += std::to_string(clusters) + " clusters";
  if (clusters < kFewClusters) {
    detail += ", fewer than " + std::to_string(too_few ? least : kFewClusters);
  }
  if (lacks_rank) {
    detail += " and no more than the " + std::to_string(coefficients) +
              (coefficients == 1 ? " coefficient" : " coefficients") +
              ", so that their covariance has no full rank";
  }
  return Condition{ConditionKind::few_clusters,
                   too_few || lacks_rank ? ConditionSeverity::warning : ConditionSeverity::note,
                   "",
                   detail};
}

void add_cluster_conditions(std::size_t clusters,
                            std::string of_one,
                            Conditions& conditions,
                            std::size_t coefficients,
                            const std::string& of,
                            std::size_t least) {
  if (clusters == 1) {
    conditions.push_back(
        {ConditionKind::one_cluster, ConditionSeverity::warning, "", std::move(of_one)});
  } else if (auto few = few_clusters(clusters, coefficients, of, least)) {
    conditions.push_back(std::move(*few));
  }
}

}  // namespace tcert::statistics
