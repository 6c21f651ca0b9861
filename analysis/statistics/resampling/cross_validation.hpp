#pragma once
/// \file
/// Cross-validation over folds of whole clusters.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/concordance/concordance.hpp>
#include <statistics/roc/placements.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

namespace tcert::statistics {

struct FoldOptions {
  std::size_t folds = 5;
  std::uint64_t seed = 1;
  std::uint32_t analysis = 0;  ///< Which stream of the seed.
};

struct Folds {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_row;  ///< Below `count`.
  std::vector<std::size_t> rows;      ///< Per fold.
  std::vector<std::size_t> failures;  ///< Per fold.
  Conditions conditions;  ///< few_clusters: fewer folds than wanted; one_cluster: no folds.
};

/// Folds of disjoint clusters with about as many failures, and then rows, each: clusters with most
/// failures first, in random order where they have as many, each to the fold with fewest failures;
/// those without failures to the fold with fewest rows. The same for the same seed, whatever the
/// order of the rows. \throws std::invalid_argument if the lengths differ, a cluster is missing or
/// `folds` is below 2. O(rows log rows).
[[nodiscard]] Folds assign_folds(std::span<const std::uint8_t> success,
                                 std::span<const std::uint32_t> cluster,
                                 const FoldOptions& options = {});

/// Rows of fold `fold`, or of all others, rising.
[[nodiscard]] std::vector<std::size_t> held_out_rows(const Folds& folds, std::size_t fold);
[[nodiscard]] std::vector<std::size_t> training_rows(const Folds& folds, std::size_t fold);

/// Fits on the training rows and scores the held-out ones, in their order.
using FitAndScore = std::function<std::vector<double>(std::span<const std::size_t> training,
                                                      std::span<const std::size_t> held_out)>;

/// Every row's score from the fit that has not seen its fold.
/// \throws std::invalid_argument if a fit returns another number of scores than it was asked for.
[[nodiscard]] std::vector<double> out_of_fold_scores(const Folds& folds, const FitAndScore& fit);

/// AUC or C of one fold, and the pairs of rows it is a mean over.
struct FoldScore {
  std::optional<double> value;
  double pairs = 0.0;
  bool without_fit = false;  ///< Its fit had no estimate; else, without a value, it has one class.
};

struct PooledScore {
  std::optional<double> value;  ///< Mean of the folds' values, weighted by their pairs.
  double pairs = 0.0;
  std::vector<FoldScore> folds;
  Conditions conditions;  ///< one_class_fold or fold_without_fit for each that is left out;
                          ///< no_comparable_pairs.
};

/// Scores every fold by itself and averages. Pairs across folds are never compared: their scores
/// come from different fits, which biases a useless predictor below 0.5.
[[nodiscard]] PooledScore pooled_within_folds(
    const Folds& folds, const std::function<FoldScore(std::span<const std::size_t> rows)>& score);

/// The AUC of out-of-fold `scores` within folds; a fold with a NaN is left out. \throws
/// std::invalid_argument if lengths differ.
[[nodiscard]] PooledScore out_of_fold_auc(const Folds& folds,
                                          std::span<const double> scores,
                                          std::span<const std::uint8_t> success,
                                          HigherMeans higher = HigherMeans::success);

/// Harrell's C of out-of-fold `scores` within folds. `outcome` has rounded times.
/// \throws std::invalid_argument if lengths differ.
[[nodiscard]] PooledScore out_of_fold_c(const Folds& folds,
                                        std::span<const double> scores,
                                        const SurvivalOutcome& outcome,
                                        LargerMeans larger = LargerMeans::shorter_time);

}  // namespace tcert::statistics
