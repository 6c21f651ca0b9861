#include <statistics/equivalence/scores_by_group.hpp>

#include <algorithm>
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

/// Distinct codes of these rows, rising: what a compact code of the rows stands for.
std::vector<std::uint32_t> clusters_of(const std::vector<std::uint32_t>& cluster,
                                       const std::vector<std::size_t>& rows) {
  std::vector<std::uint32_t> codes = chosen(cluster, rows);
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

/// The joint estimates: `influence` holds a column a group whose products are the covariances;
/// `variances` stand on the diagonal.
std::optional<GroupEstimates> joint_of(const table::Factor& group,
                                       const ScoresByGroup& scores,
                                       const Eigen::MatrixXd& influence) {
  GroupEstimates joint;
  joint.names = group.levels;
  const auto k = static_cast<Eigen::Index>(group.levels.size());
  joint.values.resize(k);
  joint.covariance = influence.transpose() * influence;
  for (Eigen::Index g = 0; g < k; ++g) {
    const GroupScore& one = scores.groups[static_cast<std::size_t>(g)];
    if (!one.value || !one.standard_error) {
      return std::nullopt;
    }
    joint.values[g] = *one.value;
    joint.covariance(g, g) = *one.standard_error * *one.standard_error;
  }
  return joint;
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

ScoresByGroup auc_by_group(const Score& score,
                           std::span<const std::uint8_t> success,
                           const table::Factor& group,
                           std::span<const std::uint32_t> cluster,
                           double level) {
  if (score.values.size() != group.rows() || success.size() != group.rows() ||
      cluster.size() != group.rows()) {
    throw std::invalid_argument("AUC by group: lengths differ");
  }
  const CompactCodes compact = compact_codes(cluster);
  ScoresByGroup result;
  Eigen::MatrixXd influence = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(compact.count),
                                                    static_cast<Eigen::Index>(group.levels.size()));
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
    const auto g = static_cast<Eigen::Index>(result.groups.size());
    result.groups.push_back(
        {one.auc, root(one.variance), one.interval, without_few_clusters(one.conditions)});
    if (joint.covariance) {
      const std::vector<std::uint32_t> clusters = clusters_of(compact.codes, rows);
      const double factor = std::sqrt(joint.parts.cross_factor);
      for (std::size_t i = 0; i < clusters.size(); ++i) {
        const auto unit = static_cast<Eigen::Index>(i);
        influence(static_cast<Eigen::Index>(clusters[i]), g) =
            factor * (joint.parts.successes(unit, 0) + joint.parts.failures(unit, 0));
      }
    }
  }
  result.joint = joint_of(group, result, influence);
  return result;
}

ScoresByGroup concordance_by_group(const SurvivalOutcome& outcome,
                                   const Predictor& predictor,
                                   const table::Factor& group,
                                   const table::Factor& cluster,
                                   double level) {
  if (predictor.values.size() != group.rows() || cluster.rows() != group.rows()) {
    throw std::invalid_argument("C by group: lengths differ");
  }
  ScoresByGroup result;
  Eigen::MatrixXd influence =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cluster.levels.size()),
                            static_cast<Eigen::Index>(group.levels.size()));
  for (const std::vector<std::size_t>& rows : rows_of_levels(group)) {
    const std::vector<double> values = chosen(predictor.values, rows);
    const table::Factor clusters = on_rows(cluster, rows);
    ConcordanceOptions options;
    options.level = level;
    options.cluster = &clusters;
    const Predictor part{predictor.name, values, predictor.larger};
    const ConcordanceResult all = concordance(on_rows(outcome, rows), {&part, 1}, options);
    const ConcordanceEstimate& one = all.estimates.front();
    const auto g = static_cast<Eigen::Index>(result.groups.size());
    Conditions conditions = all.conditions;
    conditions.insert(conditions.end(), one.conditions.begin(), one.conditions.end());
    result.groups.push_back(
        {one.c, one.std_error, one.interval, without_few_clusters(std::move(conditions))});
    for (std::size_t i = 0; i < one.dfbeta.size(); ++i) {
      influence(static_cast<Eigen::Index>(cluster.codes[rows[i]]), g) += one.dfbeta[i];
    }
  }
  result.joint = joint_of(group, result, influence);
  return result;
}

}  // namespace tcert::statistics
