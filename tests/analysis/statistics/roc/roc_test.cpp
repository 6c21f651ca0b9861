#include <statistics/roc/roc.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <table/random.hpp>
#include <utility>
#include <vector>

namespace tcert::statistics {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(Auc, CountsPairsByHand) {
  // Successes 3, 2; failures 1, 2. Pairs: 3>1, 3>2, 2>1 win, 2=2 half: 3.5 of 4.
  // V10 = {1, 0.75}, V01 (of the failures 1 and 2) = {1, 0.75}; each has variance 0.03125,
  // so the variance of the AUC is 0.03125 / 2 + 0.03125 / 2.
  const std::vector<double> score{3, 2, 1, 2};
  const std::vector<double> success{1, 1, 0, 0};
  const AucEstimate estimate = auc(score, success, HigherMeans::success);
  EXPECT_EQ(estimate.auc, 0.875);
  EXPECT_EQ(estimate.variance, 0.03125);
  const double half = 1.959963984540054 * std::sqrt(0.03125);
  EXPECT_NEAR(estimate.interval->low, 0.875 - half, 1e-14);
  EXPECT_EQ(estimate.interval->high, 1.0) << "clipped";
  EXPECT_TRUE(estimate.conditions.empty());
}

TEST(Auc, TurnsOverWithTheDirectionAndNeverByItself) {
  const std::vector<double> score{1, 2, 3, 4};
  const std::vector<double> success{1, 1, 0, 0};
  EXPECT_EQ(auc(score, success, HigherMeans::success).auc, 0.0);
  EXPECT_EQ(auc(score, success, HigherMeans::failure).auc, 1.0);
}

TEST(Auc, LeavesOutAndCountsMissingRows) {
  const std::vector<double> score{3, kNan, 2, 1, 5, 2};
  const std::vector<double> success{1, 1, 1, 0, kNan, 0};
  const AucEstimate estimate = auc(score, success, HigherMeans::success);
  EXPECT_EQ(estimate.missing, 2U);
  EXPECT_EQ(estimate.successes, 2U);
  EXPECT_EQ(estimate.failures, 2U);
  EXPECT_EQ(estimate.auc, 0.875);
}

TEST(Auc, RanksInfinitiesAtTheEnds) {
  const std::vector<double> score{kInf, 0, -kInf, 0};
  const std::vector<double> success{1, 1, 0, 0};
  EXPECT_EQ(auc(score, success, HigherMeans::success).auc, 0.875);
}

TEST(Auc, NamesWhatItCannotEstimate) {
  const AucEstimate none = auc({}, {}, HigherMeans::success);
  EXPECT_FALSE(none.auc.has_value());
  EXPECT_TRUE(has(none.conditions, ConditionKind::no_rows));

  const AucEstimate missing =
      auc(std::vector<double>{kNan}, std::vector<double>{1}, HigherMeans::success);
  EXPECT_TRUE(has(missing.conditions, ConditionKind::no_rows));

  const AucEstimate one = auc(std::vector<double>{1}, std::vector<double>{1}, HigherMeans::success);
  EXPECT_FALSE(one.auc.has_value());
  EXPECT_TRUE(has(one.conditions, ConditionKind::one_class));
  EXPECT_EQ(one.conditions[0].detail, "no failures");

  const AucEstimate failures =
      auc(std::vector<double>{1, 2, 3}, std::vector<double>{0, 0, 0}, HigherMeans::success);
  EXPECT_FALSE(failures.auc.has_value());
  EXPECT_TRUE(has_error(failures.conditions));
  EXPECT_EQ(failures.conditions[0].detail, "no successes");
}

TEST(Auc, HasNoVarianceForAClassOfOne) {
  const AucEstimate estimate =
      auc(std::vector<double>{2, 1}, std::vector<double>{1, 0}, HigherMeans::success);
  EXPECT_EQ(estimate.auc, 1.0);
  EXPECT_FALSE(estimate.variance.has_value());
  EXPECT_FALSE(estimate.interval.has_value());
  ASSERT_EQ(estimate.conditions.size(), 3U);
  EXPECT_TRUE(has(estimate.conditions, ConditionKind::rare_class));
  EXPECT_EQ(estimate.conditions[0].detail, "a single success");
  EXPECT_EQ(estimate.conditions[1].detail, "a single failure");
  EXPECT_TRUE(has(estimate.conditions, ConditionKind::separated));
}

TEST(Auc, SaysThatAConstantPredictorSaysNothing) {
  const AucEstimate estimate =
      auc(std::vector<double>(6, 0.2), std::vector<double>{1, 0, 1, 0, 1, 0}, HigherMeans::success);
  EXPECT_EQ(estimate.auc, 0.5);
  EXPECT_EQ(estimate.variance, 0.0);
  EXPECT_TRUE(has(estimate.conditions, ConditionKind::all_tied));
}

TEST(Auc, RefusesMisuse) {
  const std::vector<double> score{1, 2};
  EXPECT_THROW(static_cast<void>(auc(score, std::vector<double>{1}, HigherMeans::success)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(auc(score, std::vector<double>{1, 2}, HigherMeans::success)),
               std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(auc(score, std::vector<double>{1, 0}, HigherMeans::success, {1.0, {}})),
      std::invalid_argument);
}

/// Row and column means of the matrix of pairs, as the definition has them.
struct PairMeans {
  std::vector<double> successes;
  std::vector<double> failures;
  double auc = 0.0;
};

PairMeans pair_means(const std::vector<double>& score, const std::vector<double>& success) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < score.size(); ++i) {
    (success[i] == 1.0 ? x : y).push_back(score[i]);
  }
  PairMeans means;
  means.successes.assign(x.size(), 0.0);
  means.failures.assign(y.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      const double win = x[i] > y[j] ? 1.0 : (x[i] == y[j] ? 0.5 : 0.0);
      means.successes[i] += win / static_cast<double>(y.size());
      means.failures[j] += win / static_cast<double>(x.size());
    }
  }
  for (const double v : means.successes) {
    means.auc += v / static_cast<double>(x.size());
  }
  return means;
}

double covariance(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0.0;
  double mean_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / n;
    mean_b += b[i] / n;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return sum / (n - 1.0) / n;
}

TEST(PairedAucTest, EqualsTheMatrixOfPairsOnRandomTiedScores) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    table::RandomStream random(seed, 1, 0);
    std::vector<double> a;
    std::vector<double> b;
    std::vector<double> success{0, 0, 1, 1};
    const std::uint32_t n = 4 + random.below(40);
    const std::uint32_t levels = 2 + random.below(12);
    while (success.size() < n) {
      success.push_back(random.below(3) == 0 ? 0 : 1);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      a.push_back(random.below(levels) + success[i]);
      b.push_back(-static_cast<double>(random.below(levels)));
    }
    const PairMeans A = pair_means(a, success);
    const PairMeans B = pair_means(b, success);
    const double var_a = covariance(A.successes, A.successes) + covariance(A.failures, A.failures);
    const double var_b = covariance(B.successes, B.successes) + covariance(B.failures, B.failures);
    const double cov = covariance(A.successes, B.successes) + covariance(A.failures, B.failures);

    const AucEstimate estimate = auc(a, success, HigherMeans::success);
    EXPECT_NEAR(estimate.auc.value(), A.auc, 1e-13);
    EXPECT_NEAR(estimate.variance.value(), var_a, 1e-13);
    EXPECT_NEAR(auc(a, success, HigherMeans::failure).auc.value(), 1.0 - A.auc, 1e-13);

    const AucDifference difference =
        paired_auc_test({a, HigherMeans::success}, {b, HigherMeans::success}, success);
    EXPECT_NEAR(difference.difference.value(), A.auc - B.auc, 1e-13);
    EXPECT_NEAR(difference.variance.value(), var_a + var_b - 2.0 * cov, 1e-13);

    // A reversed predictor read in the reversed direction is the same predictor.
    std::vector<double> reversed = b;
    for (double& x : reversed) {
      x = -x;
    }
    const AucDifference mirrored =
        paired_auc_test({a, HigherMeans::success}, {reversed, HigherMeans::failure}, success);
    EXPECT_EQ(mirrored.difference, difference.difference);
    EXPECT_EQ(mirrored.p_value, difference.p_value);
  }
}

TEST(PairedAucTest, UsesTheRowsCompleteInBoth) {
  const std::vector<double> a{4, 3, kNan, 1, 2, 2};
  const std::vector<double> b{4, kNan, 3, 1, 3, 2};
  const std::vector<double> success{1, 1, 1, 0, 0, 1};
  const AucDifference difference =
      paired_auc_test({a, HigherMeans::success}, {b, HigherMeans::success}, success);
  EXPECT_EQ(difference.missing, 2U);
  EXPECT_EQ(difference.successes, 2U);
  EXPECT_EQ(difference.failures, 2U);
  EXPECT_EQ(difference.first_auc, 0.875);
  EXPECT_EQ(difference.second_auc, 0.75);
}

TEST(PairedAucTest, NamesPredictorsThatRankAlike) {
  const std::vector<double> a{4, 3, 2, 1, 5};
  std::vector<double> b;
  for (const double x : a) {
    b.push_back(x * x);
  }
  const std::vector<double> success{1, 0, 1, 0, 1};
  const AucDifference difference =
      paired_auc_test({a, HigherMeans::success}, {b, HigherMeans::success}, success);
  EXPECT_EQ(difference.difference, 0.0);
  EXPECT_EQ(difference.p_value, 1.0);
  EXPECT_TRUE(has(difference.conditions, ConditionKind::same_ranking));
}

TEST(PairedAucTest, GivesNoPWithoutVariance) {
  const std::vector<double> separated{4, 3, 2, 1};
  const std::vector<double> constant(4, 1.0);
  const std::vector<double> success{1, 1, 0, 0};
  const AucDifference difference =
      paired_auc_test({separated, HigherMeans::success}, {constant, HigherMeans::success}, success);
  EXPECT_EQ(difference.difference, 0.5);
  EXPECT_FALSE(difference.p_value.has_value());
  EXPECT_TRUE(has(difference.conditions, ConditionKind::zero_variance));
}

/// Share of 95 % intervals that cover the true AUC of two unit normals `shift` apart.
std::pair<double, double> coverage(double shift, double truth) {
  constexpr int kDataSets = 2000;
  int covered = 0;
  double sum = 0.0;
  for (int k = 0; k < kDataSets; ++k) {
    table::RandomStream random(11, shift == 0.0 ? 0 : 1, static_cast<std::uint64_t>(k));
    std::vector<double> score;
    std::vector<double> success;
    for (int i = 0; i < 660; ++i) {
      success.push_back(i < 583 ? 1 : 0);
      score.push_back(random.normal() + shift * success.back());
    }
    const AucEstimate estimate = auc(score, success, HigherMeans::success);
    sum += estimate.auc.value();
    if (estimate.interval->low <= truth && truth <= estimate.interval->high) {
      ++covered;
    }
  }
  return {static_cast<double>(covered) / kDataSets, sum / kDataSets};
}

TEST(Auc, IntervalCoversTheTruthAtItsNominalRate) {
  // 2,000 data sets of the study's size: the Monte-Carlo SD of a coverage is 0.0049.
  const auto [null_coverage, null_mean] = coverage(0.0, 0.5);
  std::printf("DeLong 95 %% interval, n = 660: covers AUC 0.5 in %.4f of the data sets\n",
              null_coverage);
  EXPECT_NEAR(null_mean, 0.5, 0.002);
  EXPECT_NEAR(null_coverage, 0.95, 3.0 * 0.0049);

  const double shift = 1.0;
  const double truth = 0.5 * std::erfc(-shift / 2.0);  // Phi(shift / sqrt 2)
  const auto [coverage_at_shift, mean_at_shift] = coverage(shift, truth);
  std::printf("DeLong 95 %% interval, n = 660: covers AUC %.3f in %.4f of the data sets\n",
              truth,
              coverage_at_shift);
  EXPECT_NEAR(mean_at_shift, truth, 0.002);
  // Off the centre the interval is a little short: the AUC is skewed, a Wald interval is not.
  EXPECT_NEAR(coverage_at_shift, 0.94, 3.0 * 0.0053);
}

}  // namespace
}  // namespace tcert::statistics
