#pragma once
/// \file
/// Areas under the ROC curves of any number of markers on the same rows, with DeLong's covariance
/// or, where rows come in clusters, Obuchowski's (1997); tests of two areas.
/// Checked against pROC: `auc`, `var`, `cov`, `ci.auc`, `roc.test` by "delong", with the direction
/// given and never taken from the data. pROC has no clustered form; its method "obuchowski" is the
/// binormal formula of Obuchowski & McClish, another thing, which is not here.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/alternative.hpp>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/roc/placements.hpp>
#include <vector>

namespace tcert::statistics {

/// A predictor with its a-priori direction.
struct Score {
  std::span<const double> values;  ///< May hold infinities; NaN is missing.
  HigherMeans higher = HigherMeans::success;
};

struct AucOptions {
  double level = 0.95;  ///< Of the intervals, in (0, 1).
  /// One code a row, as in Factor; Factor::kMissing is missing. Empty: the rows are independent.
  std::span<const std::uint32_t> cluster{};
};

/// Conditions have no column: these functions do not know their columns' names.
struct AucEstimate {
  std::size_t successes = 0;  ///< Among the complete rows.
  std::size_t failures = 0;
  std::size_t missing = 0;   ///< Rows left out: a score, the outcome or the cluster is missing.
  std::size_t clusters = 0;  ///< 0 if rows are taken as independent.
  std::optional<double> auc;
  std::optional<double> variance;
  std::optional<Interval> interval;  ///< Wald on the AUC, clipped to [0, 1].
  /// no_rows, one_class: no AUC. rare_class, one_cluster: no variance. all_tied, separated: an AUC
  /// whose variance 0 misleads. few_clusters.
  Conditions conditions;
};

/// The centred structural components of K markers, which any covariance is made of. A unit is a
/// row of its class, or a cluster.
struct AucParts {
  Eigen::MatrixXd successes;    ///< units x K: sums of V10 - AUC in a unit, over all successes M.
  Eigen::MatrixXd failures;     ///< units x K: sums of V01 - AUC in a unit, over all failures N.
  bool clustered = false;       ///< Row i of both is the same cluster.
  double success_factor = 0.0;  ///< I10 / (I10 - 1), I10 units with a success.
  double failure_factor = 0.0;  ///< I01 / (I01 - 1), I01 units with a failure.
  double cross_factor = 0.0;    ///< I / (I - 1), I clusters.
};

struct JointAuc {
  std::vector<AucEstimate> markers;           ///< As given, on the rows complete in all of them.
  std::optional<Eigen::MatrixXd> covariance;  ///< K x K, of the AUCs.
  AucParts parts;                             ///< Empty matrices where there is no covariance.
  double level = 0.95;
};

/// The AUCs of K markers, Pr(a success outranks a failure) with ties counting one half, and their
/// covariance. With M successes, N failures and the components V10, V01 of DeLong, DeLong &
/// Clarke-Pearson (1988), summed within clusters i (m_i successes, n_i failures):
///   a_i = (V10(X_i.) - m_i AUC) / M,  b_i = (V01(Y_i.) - n_i AUC) / N,
///   var = I10/(I10-1) sum a_i^2 + I01/(I01-1) sum b_i^2 + 2 I/(I-1) sum a_i b_i
/// (Obuchowski 1997, Biometrics 53:567, eq. 2-5 and, for two markers, the same with products).
/// Clusters of one row each have no cross term and I10 = M, I01 = N: DeLong's variance exactly.
/// As I10, I01 <= I the variance is never negative.
/// `success` holds 0, 1 or NaN. \throws std::invalid_argument if the lengths differ, an outcome is
/// another number, `level` is not in (0, 1) or there is no score. O(K n log n + K^2 units).
[[nodiscard]] JointAuc joint_auc(std::span<const Score> scores,
                                 std::span<const double> success,
                                 const AucOptions& options = {});

/// One marker alone: `joint_auc` of it.
[[nodiscard]] AucEstimate auc(std::span<const double> score,
                              std::span<const double> success,
                              HigherMeans higher,
                              const AucOptions& options = {});

struct AucDifference {
  std::size_t successes = 0;
  std::size_t failures = 0;
  std::size_t missing = 0;   ///< Rows where either score, the outcome or the cluster is missing.
  std::size_t clusters = 0;  ///< 0 if rows are taken as independent.
  std::optional<double> first_auc;
  std::optional<double> second_auc;
  std::optional<double> difference;  ///< First minus second.
  std::optional<double> variance;
  std::optional<Interval> interval;  ///< Two-sided, whatever the alternative.
  std::optional<double> z;
  std::optional<double> p_value;  ///< Normal.
  Conditions conditions;          ///< As an AUC's; same_ranking: p is 1; zero_variance: no test.
};

/// AUC of marker `first` minus that of `second`, on the same rows, plain or clustered as `joint`
/// is. The variance is that of the differences of the parts: var + var - 2 cov without the
/// cancellation. \throws std::invalid_argument if a marker is not there.
[[nodiscard]] AucDifference auc_contrast(const JointAuc& joint,
                                         std::size_t first,
                                         std::size_t second,
                                         Alternative alternative = Alternative::two_sided);

/// DeLong's test of two AUCs on the rows complete in both: `joint_auc`, then `auc_contrast`.
[[nodiscard]] AucDifference paired_auc_test(const Score& first,
                                            const Score& second,
                                            std::span<const double> success,
                                            const AucOptions& options = {},
                                            Alternative alternative = Alternative::two_sided);

struct UnpairedAucTest {
  std::optional<double> difference;  ///< First minus second.
  std::optional<double> variance;
  std::optional<Interval> interval;  ///< By Student's t, two-sided.
  std::optional<double> t;
  std::optional<double> degrees_of_freedom;
  std::optional<double> p_value;
  Conditions conditions;
};

/// Two AUCs from different rows: t = (A - B) / sqrt(var A + var B) with Welch's degrees of freedom
/// (var A + var B)^2 / (var A^2 / (n_A - 1) + var B^2 / (n_B - 1)), n the rows, or the clusters
/// where the variance is clustered. As pROC's `roc.test(paired = FALSE)`.
/// \throws std::invalid_argument if `level` is not in (0, 1).
[[nodiscard]] UnpairedAucTest unpaired_auc_test(const AucEstimate& first,
                                                const AucEstimate& second,
                                                Alternative alternative = Alternative::two_sided,
                                                double level = 0.95);

}  // namespace tcert::statistics
