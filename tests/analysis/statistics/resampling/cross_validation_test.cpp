#include <statistics/resampling/cross_validation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <statistics/roc/roc.hpp>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

struct Data {
  std::vector<std::uint8_t> success;
  std::vector<std::uint32_t> cluster;
};

Data study(std::uint64_t seed) {
  table::RandomStream random(seed, 6, 0);
  Data data;
  for (std::uint32_t day = 0; day < 22; ++day) {
    for (int trial = 0; trial < 30; ++trial) {
      data.success.push_back(random.below(9) == 0 ? 0 : 1);
      data.cluster.push_back(100 + day);
    }
  }
  return data;
}

TEST(Folds, KeepClustersWholeAndBalanceFailuresAndRows) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Data data = study(seed);
    const Folds folds = assign_folds(data.success, data.cluster, {5, seed, 0});
    ASSERT_EQ(folds.count, 5U);
    std::map<std::uint32_t, std::set<std::uint32_t>> seen;
    for (std::size_t row = 0; row < data.success.size(); ++row) {
      seen[data.cluster[row]].insert(folds.of_row[row]);
    }
    for (const auto& [cluster, of] : seen) {
      EXPECT_EQ(of.size(), 1U);
    }
    const auto [least, most] = std::minmax_element(folds.failures.begin(), folds.failures.end());
    EXPECT_LE(*most - *least, 4U);
    std::size_t rows = 0;
    for (std::size_t fold = 0; fold < 5; ++fold) {
      rows += folds.rows[fold];
      EXPECT_EQ(held_out_rows(folds, fold).size(), folds.rows[fold]);
      EXPECT_EQ(training_rows(folds, fold).size(), data.success.size() - folds.rows[fold]);
    }
    EXPECT_EQ(rows, data.success.size());
  }
}

TEST(Folds, DependOnTheSeedButNotOnTheOrderOfRows) {
  const Data data = study(1);
  const Folds folds = assign_folds(data.success, data.cluster, {5, 1, 0});
  EXPECT_EQ(assign_folds(data.success, data.cluster, {5, 1, 0}).of_row, folds.of_row);
  EXPECT_NE(assign_folds(data.success, data.cluster, {5, 2, 0}).of_row, folds.of_row);
  Data turned = data;
  std::reverse(turned.success.begin(), turned.success.end());
  std::reverse(turned.cluster.begin(), turned.cluster.end());
  std::vector<std::uint32_t> of_row =
      assign_folds(turned.success, turned.cluster, {5, 1, 0}).of_row;
  std::reverse(of_row.begin(), of_row.end());
  EXPECT_EQ(of_row, folds.of_row);
}

TEST(Folds, AreFewerWhereClustersAre) {
  const std::vector<std::uint8_t> success{0, 1, 0, 1};
  const Folds two = assign_folds(success, std::vector<std::uint32_t>{3, 3, 8, 8});
  EXPECT_EQ(two.count, 2U);
  EXPECT_TRUE(has(two.conditions, ConditionKind::few_clusters));
  const Folds none = assign_folds(success, std::vector<std::uint32_t>(4, 1));
  EXPECT_EQ(none.count, 0U);
  EXPECT_TRUE(has(none.conditions, ConditionKind::one_cluster));
  EXPECT_THROW(static_cast<void>(assign_folds(success, std::vector<std::uint32_t>{1})),
               std::invalid_argument);
}

Folds by_hand() {
  Folds folds;
  folds.count = 3;
  folds.of_row = {0, 0, 0, 1, 1, 2, 2, 2};
  return folds;
}

TEST(OutOfFoldAuc, AveragesFoldsByTheirPairs) {
  // Fold 0: successes 3, 1 against failure 2: 1 of 2 pairs. Fold 1: successes alone. Fold 2:
  // success 5 against failures 4, 5: 1.5 of 2 pairs. Together 2.5 of 4.
  const std::vector<double> scores{3, 1, 2, 9, 9, 5, 4, 5};
  const std::vector<std::uint8_t> success{1, 1, 0, 1, 1, 1, 0, 0};
  const PooledScore pooled = out_of_fold_auc(by_hand(), scores, success);
  EXPECT_EQ(pooled.value, 0.625);
  EXPECT_EQ(pooled.pairs, 4.0);
  EXPECT_EQ(pooled.folds[0].value, 0.5);
  EXPECT_FALSE(pooled.folds[1].value.has_value());
  ASSERT_EQ(pooled.conditions.size(), 1U);
  EXPECT_EQ(pooled.conditions[0].kind, ConditionKind::one_class_fold);
  EXPECT_EQ(pooled.conditions[0].detail, "fold 2 of 3");
  EXPECT_EQ(out_of_fold_auc(by_hand(), scores, success, HigherMeans::failure).value, 0.375);

  const PooledScore none = out_of_fold_auc(by_hand(), scores, std::vector<std::uint8_t>(8, 1));
  EXPECT_FALSE(none.value.has_value());
  EXPECT_TRUE(has_error(none.conditions));
}

TEST(OutOfFoldC, AveragesFoldsByTheirPairs) {
  // Fold 0: times 1, 2, 3, all events, risks 3, 1, 2: 2 of 3 pairs. Fold 1: censored alone. Fold 2:
  // times 1, 2, 2+ with an event first: risks 5, 4, 5: 1.5 of 2 pairs, and event 2 before 2+: 0 of
  // 1. Together 3.5 of 6.
  SurvivalOutcome outcome;
  outcome.stop = {1, 2, 3, 7, 8, 1, 2, 2};
  outcome.event = {1, 1, 1, 0, 0, 1, 1, 0};
  const std::vector<double> risk{3, 1, 2, 9, 9, 5, 4, 5};
  const PooledScore pooled = out_of_fold_c(by_hand(), risk, outcome);
  EXPECT_DOUBLE_EQ(pooled.value.value(), 3.5 / 6.0);
  EXPECT_EQ(pooled.pairs, 6.0);
  EXPECT_TRUE(has(pooled.conditions, ConditionKind::one_class_fold));
  EXPECT_DOUBLE_EQ(out_of_fold_c(by_hand(), risk, outcome, LargerMeans::longer_time).value.value(),
                   2.5 / 6.0);
}

TEST(OutOfFoldScores, ComeFromTheOtherFolds) {
  const std::vector<double> scores = out_of_fold_scores(
      by_hand(), [](std::span<const std::size_t> training, std::span<const std::size_t> held_out) {
        return std::vector<double>(held_out.size(), static_cast<double>(training.size()));
      });
  EXPECT_EQ(scores, (std::vector<double>{5, 5, 5, 6, 6, 5, 5, 5}));
  EXPECT_THROW(static_cast<void>(out_of_fold_scores(
                   by_hand(),
                   [](std::span<const std::size_t>, std::span<const std::size_t>) {
                     return std::vector<double>{};
                   })),
               std::invalid_argument);
}

TEST(OutOfFoldAuc, LeavesOutAFoldWithoutAFit) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Folds folds;
  folds.count = 2;
  folds.of_row = {0, 0, 0, 1, 1, 1};
  const std::vector<double> scores{1, 2, 3, kNaN, kNaN, kNaN};
  const std::vector<std::uint8_t> success{0, 1, 1, 0, 1, 1};
  const PooledScore score = out_of_fold_auc(folds, scores, success);
  EXPECT_EQ(score.value, 1.0);
  ASSERT_EQ(score.conditions.size(), 1U);
  EXPECT_EQ(score.conditions[0].kind, ConditionKind::fold_without_fit);
  EXPECT_EQ(score.conditions[0].detail, "fold 2 of 2");
  const SurvivalOutcome outcome{{}, {3, 2, 1, 1, 2, 3}, {1, 1, 1, 1, 1, 1}};
  const PooledScore c = out_of_fold_c(folds, scores, outcome, LargerMeans::shorter_time);
  EXPECT_EQ(c.value, 1.0);
  EXPECT_EQ(c.conditions[0].kind, ConditionKind::fold_without_fit);
  EXPECT_THROW(static_cast<void>(placements(scores, success, HigherMeans::success)),
               std::invalid_argument);
}

TEST(OutOfFoldAuc, IsOneHalfForAMeanThatKnowsNothing) {
  // The training mean of a null outcome predicts the held-out one backwards: a fold rich in
  // failures leaves a training set poor in them. Pooled over folds the AUC is well below 0.5;
  // within folds every score is tied.
  double within = 0.0;
  double across = 0.0;
  constexpr int kStudies = 50;
  for (std::uint64_t seed = 0; seed < kStudies; ++seed) {
    const Data data = study(seed);
    const Folds folds = assign_folds(data.success, data.cluster, {5, seed, 0});
    const std::vector<double> scores = out_of_fold_scores(
        folds, [&](std::span<const std::size_t> training, std::span<const std::size_t> held_out) {
          double successes = 0.0;
          for (const std::size_t row : training) {
            successes += data.success[row];
          }
          return std::vector<double>(held_out.size(),
                                     successes / static_cast<double>(training.size()));
        });
    within += out_of_fold_auc(folds, scores, data.success).value.value() / kStudies;
    const std::vector<double> outcome(data.success.begin(), data.success.end());
    across += auc(scores, outcome, HigherMeans::success).auc.value() / kStudies;
  }
  EXPECT_NEAR(within, 0.5, 1e-14);
  EXPECT_LT(across, 0.5);
}

}  // namespace
}  // namespace tcert::statistics
