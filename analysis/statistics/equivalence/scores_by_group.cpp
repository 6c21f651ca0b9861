#include <statistics/equivalence/scores_by_group.hpp>

#include <cmath>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/model/factor_levels.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

template <class Values>
auto chosen(const Values& values, const std::vector<std::size_t>& rows) {
  std::vector<typename Values::value_type> result;
  result.reserve(rows.size());
  for (const std::size_t row : rows) {
    result.push_back(values[row]);
  }
  return result;
}

std::optional<double> root(const std::optional<double>& variance) {
  return variance ? std::optional(std::sqrt(*variance)) : std::nullopt;
}

/// The panel, not each group, says that clusters are few.
Conditions without_few_clusters(Conditions conditions) {
  std::erase_if(conditions, [](const Condition& condition) {
    return condition.kind == ConditionKind::few_clusters;
  });
  return conditions;
}

}  // namespace

std::vector<std::vector<std::size_t>> rows_of_levels(const table::Factor& factor) {
  std::vector<std::vector<std::size_t>> rows(factor.levels.size());
  for (std::size_t row = 0; row < factor.rows(); ++row) {
    if (factor.codes[row] == table::Factor::kMissing) {
      throw std::invalid_argument("scores by group: a group is missing");
    }
    rows[factor.codes[row]].push_back(row);
  }
  return rows;
}

std::vector<GroupScore> auc_by_group(const Score& score,
                                     std::span<const std::uint8_t> success,
                                     const table::Factor& group,
                                     std::span<const std::uint32_t> cluster,
                                     double level) {
  if (score.values.size() != group.rows() || success.size() != group.rows() ||
      cluster.size() != group.rows()) {
    throw std::invalid_argument("AUC by group: lengths differ");
  }
  const CompactCodes compact = compact_codes(cluster);
  std::vector<GroupScore> groups;
  for (const std::vector<std::size_t>& rows : rows_of_levels(group)) {
    const std::vector<double> values = chosen(score.values, rows);
    const std::vector<double> outcome = [&] {
      const std::vector<std::uint8_t> part = chosen(success, rows);
      return std::vector<double>(part.begin(), part.end());
    }();
    const std::vector<std::uint32_t> codes = chosen(compact.codes, rows);
    const Score part{values, score.higher};
    const JointAuc joint = joint_auc({&part, 1}, outcome, {level, codes});
    const AucEstimate& one = joint.markers.front();
    groups.push_back(
        {one.auc, root(one.variance), one.interval, without_few_clusters(one.conditions)});
  }
  return groups;
}

std::vector<GroupScore> concordance_by_group(const SurvivalOutcome& outcome,
                                             const Predictor& predictor,
                                             const table::Factor& group,
                                             const table::Factor& cluster,
                                             double level) {
  if (predictor.values.size() != group.rows() || cluster.rows() != group.rows()) {
    throw std::invalid_argument("C by group: lengths differ");
  }
  std::vector<GroupScore> groups;
  for (const std::vector<std::size_t>& rows : rows_of_levels(group)) {
    const std::vector<double> values = chosen(predictor.values, rows);
    const table::Factor clusters = on_rows(cluster, rows);
    ConcordanceOptions options;
    options.level = level;
    options.cluster = &clusters;
    const Predictor part{predictor.name, values, predictor.larger};
    const ConcordanceResult all = concordance(on_rows(outcome, rows), {&part, 1}, options);
    const ConcordanceEstimate& one = all.estimates.front();
    Conditions conditions = all.conditions;
    conditions.insert(conditions.end(), one.conditions.begin(), one.conditions.end());
    groups.push_back(
        {one.c, one.std_error, one.interval, without_few_clusters(std::move(conditions))});
  }
  return groups;
}

}  // namespace tcert::statistics
