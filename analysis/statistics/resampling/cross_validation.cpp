#include <statistics/resampling/cross_validation.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/concordance/concordance_replicates.hpp>
#include <stdexcept>
#include <string>
#include <table/random.hpp>

namespace tcert::statistics {
namespace {

struct ClusterCount {
  std::size_t cluster = 0;
  std::size_t rows = 0;
  std::size_t failures = 0;
};

std::vector<ClusterCount> count_clusters(const CompactCodes& codes,
                                         std::span<const std::uint8_t> success) {
  std::vector<ClusterCount> counts(codes.count);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts[k].cluster = k;
  }
  for (std::size_t row = 0; row < success.size(); ++row) {
    ClusterCount& count = counts[codes.codes[row]];
    ++count.rows;
    count.failures += success[row] == 0 ? 1 : 0;
  }
  return counts;
}

void shuffle(std::vector<ClusterCount>& clusters, const FoldOptions& options) {
  table::RandomStream random(options.seed, options.analysis, 0);
  for (std::size_t k = clusters.size(); k > 1; --k) {
    std::swap(clusters[k - 1], clusters[random.below(static_cast<std::uint32_t>(k))]);
  }
}

std::size_t lightest_fold(const Folds& folds, const ClusterCount& cluster) {
  std::size_t best = 0;
  for (std::size_t fold = 1; fold < folds.count; ++fold) {
    const bool fewer_rows = folds.rows[fold] < folds.rows[best];
    const bool lighter = cluster.failures == 0 || folds.failures[fold] == folds.failures[best]
                             ? fewer_rows
                             : folds.failures[fold] < folds.failures[best];
    best = lighter ? fold : best;
  }
  return best;
}

std::vector<std::size_t> rows_where(const Folds& folds, std::size_t fold, bool held_out) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < folds.of_row.size(); ++row) {
    if ((folds.of_row[row] == fold) == held_out) {
      rows.push_back(row);
    }
  }
  return rows;
}

/// NaN in a fold says that its fit has no estimate.
bool some_missing(std::span<const double> scores) {
  return std::any_of(scores.begin(), scores.end(), [](double x) { return std::isnan(x); });
}

}  // namespace

Folds assign_folds(std::span<const std::uint8_t> success,
                   std::span<const std::uint32_t> cluster,
                   const FoldOptions& options) {
  if (success.size() != cluster.size() || options.folds < 2) {
    throw std::invalid_argument(
        "cross-validation: two folds and a cluster for each row are needed");
  }
  const CompactCodes codes = compact_codes(cluster);
  Folds folds;
  if (codes.count < 2) {
    folds.conditions.push_back({ConditionKind::one_cluster, ConditionSeverity::error, "", ""});
    return folds;
  }
  folds.count = std::min(options.folds, codes.count);
  if (folds.count < options.folds) {
    folds.conditions.push_back(
        {ConditionKind::few_clusters,
         ConditionSeverity::note,
         "",
         std::to_string(codes.count) + " clusters for " + std::to_string(options.folds) + " folds",
         "each cluster is a fold of its own"});
  }
  folds.rows.assign(folds.count, 0);
  folds.failures.assign(folds.count, 0);

  std::vector<ClusterCount> clusters = count_clusters(codes, success);
  shuffle(clusters, options);
  std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
    return a.failures > b.failures;
  });
  std::vector<std::uint32_t> fold_of(codes.count);
  for (const ClusterCount& one : clusters) {
    const std::size_t fold = lightest_fold(folds, one);
    fold_of[one.cluster] = static_cast<std::uint32_t>(fold);
    folds.rows[fold] += one.rows;
    folds.failures[fold] += one.failures;
  }
  folds.of_row.reserve(success.size());
  for (const std::uint32_t code : codes.codes) {
    folds.of_row.push_back(fold_of[code]);
  }
  return folds;
}

std::vector<std::size_t> held_out_rows(const Folds& folds, std::size_t fold) {
  return rows_where(folds, fold, true);
}

std::vector<std::size_t> training_rows(const Folds& folds, std::size_t fold) {
  return rows_where(folds, fold, false);
}

std::vector<double> out_of_fold_scores(const Folds& folds, const FitAndScore& fit) {
  std::vector<double> scores(folds.of_row.size());
  for (std::size_t fold = 0; fold < folds.count; ++fold) {
    const std::vector<std::size_t> held_out = held_out_rows(folds, fold);
    const std::vector<double> of_fold = fit(training_rows(folds, fold), held_out);
    if (of_fold.size() != held_out.size()) {
      throw std::invalid_argument("cross-validation: a fit did not score the held-out rows");
    }
    for (std::size_t k = 0; k < held_out.size(); ++k) {
      scores[held_out[k]] = of_fold[k];
    }
  }
  return scores;
}

PooledScore pooled_within_folds(
    const Folds& folds, const std::function<FoldScore(std::span<const std::size_t> rows)>& score) {
  PooledScore pooled;
  double sum = 0.0;
  for (std::size_t fold = 0; fold < folds.count; ++fold) {
    const FoldScore one = score(held_out_rows(folds, fold));
    pooled.folds.push_back(one);
    if (!one.value) {
      pooled.conditions.push_back(
          {one.without_fit ? ConditionKind::fold_without_fit : ConditionKind::one_class_fold,
           ConditionSeverity::note,
           "",
           "fold " + std::to_string(fold + 1) + " of " + std::to_string(folds.count)});
      continue;
    }
    sum += *one.value * one.pairs;
    pooled.pairs += one.pairs;
  }
  if (pooled.pairs > 0.0) {
    pooled.value = sum / pooled.pairs;
  } else {
    pooled.conditions.push_back(
        {ConditionKind::no_comparable_pairs, ConditionSeverity::error, "", "in any fold"});
  }
  return pooled;
}

PooledScore out_of_fold_auc(const Folds& folds,
                            std::span<const double> scores,
                            std::span<const std::uint8_t> success,
                            HigherMeans higher) {
  if (scores.size() != folds.of_row.size() || success.size() != folds.of_row.size()) {
    throw std::invalid_argument("cross-validation: a score and an outcome for each row are needed");
  }
  return pooled_within_folds(folds, [&](std::span<const std::size_t> rows) {
    std::vector<double> score_of_fold;
    std::vector<std::uint8_t> success_of_fold;
    std::size_t successes = 0;
    for (const std::size_t row : rows) {
      score_of_fold.push_back(scores[row]);
      success_of_fold.push_back(success[row]);
      successes += success[row] != 0 ? 1 : 0;
    }
    FoldScore result;
    result.without_fit = some_missing(score_of_fold);
    if (!result.without_fit && successes > 0 && successes < rows.size()) {
      result.value = placements(score_of_fold, success_of_fold, higher).auc;
      result.pairs = static_cast<double>(successes) * static_cast<double>(rows.size() - successes);
    }
    return result;
  });
}

PooledScore out_of_fold_c(const Folds& folds,
                          std::span<const double> scores,
                          const SurvivalOutcome& outcome,
                          LargerMeans larger) {
  if (scores.size() != folds.of_row.size() || outcome.rows() != folds.of_row.size()) {
    throw std::invalid_argument("cross-validation: a score and an outcome for each row are needed");
  }
  return pooled_within_folds(folds, [&](std::span<const std::size_t> rows) {
    SurvivalOutcome of_fold;
    std::vector<double> score_of_fold;
    for (const std::size_t row : rows) {
      if (outcome.left_truncated()) {
        of_fold.start.push_back(outcome.start[row]);
      }
      of_fold.stop.push_back(outcome.stop[row]);
      of_fold.event.push_back(outcome.event[row]);
      score_of_fold.push_back(scores[row]);
    }
    FoldScore result;
    result.without_fit = some_missing(score_of_fold);
    if (result.without_fit) {
      return result;
    }
    const ConcordanceReplicates c(of_fold, {"", score_of_fold, larger});
    ConcordanceReplicates::Scratch scratch;
    const auto counts = c.counts(std::vector<std::uint32_t>(rows.size(), 1), scratch);
    const std::uint64_t pairs = counts.concordant + counts.discordant + counts.tied_x;
    if (pairs > 0) {
      result.pairs = static_cast<double>(pairs);
      result.value =
          static_cast<double>(2 * counts.concordant + counts.tied_x) / (2.0 * result.pairs);
    }
    return result;
  });
}

}  // namespace tcert::statistics
