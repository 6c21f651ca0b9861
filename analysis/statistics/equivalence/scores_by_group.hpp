#pragma once
/// \file
/// AUC and C of one predictor in each group of rows, with the joint covariance that clusters shared
/// between groups give them.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/concordance/concordance.hpp>
#include <statistics/equivalence/equivalence.hpp>
#include <statistics/roc/roc.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

struct GroupScore {
  std::optional<double> value;
  std::optional<double> standard_error;
  std::optional<Interval> interval;  ///< Wald, clipped to [0, 1].
  Conditions conditions;             ///< Without few_clusters.
};

struct ScoresByGroup {
  std::vector<GroupScore> groups;       ///< One a level.
  std::optional<GroupEstimates> joint;  ///< Empty if a group has no estimate or no variance.
};

/// The AUC of each group by itself. Variances are Obuchowski's (1997) of the group; with a_gi, b_gi
/// the centred components of the successes and failures of cluster i in group g (see `joint_auc`)
/// the covariance of groups g and h is
///   sqrt(f_g f_h) sum_i (a_gi + b_gi) (a_hi + b_hi),  f_g = I_g / (I_g - 1), I_g clusters,
/// over the clusters that both have. The matrix is never indefinite: Obuchowski's variance is at
/// least f_g sum (a + b)^2. \throws std::invalid_argument as `joint_auc`, or if a code is missing.
[[nodiscard]] ScoresByGroup auc_by_group(const Score& score,
                                         std::span<const std::uint8_t> success,
                                         const table::Factor& group,
                                         std::span<const std::uint32_t> cluster,
                                         double level = 0.95);

/// Harrell's C of each group by itself: only trials of the same group are compared. Covariances are
/// sums over clusters of the products of their summed dfbetas, as the variance of `concordance` is
/// of squares. \throws std::invalid_argument as `concordance`.
[[nodiscard]] ScoresByGroup concordance_by_group(const SurvivalOutcome& outcome,
                                                 const Predictor& predictor,
                                                 const table::Factor& group,
                                                 const table::Factor& cluster,
                                                 double level = 0.95);

/// Rows of each level.
[[nodiscard]] std::vector<std::vector<std::size_t>> rows_of_levels(const table::Factor& factor);

}  // namespace tcert::statistics
