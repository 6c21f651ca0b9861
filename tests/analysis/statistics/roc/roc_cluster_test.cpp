// Obuchowski's clustered covariance of AUCs, by hand and against the paper's sums over all pairs.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <statistics/roc/roc.hpp>
#include <stdexcept>
#include <table/factor.hpp>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

struct Data {
  std::vector<double> success;
  std::vector<std::uint32_t> cluster;
  std::vector<std::vector<double>> scores;

  [[nodiscard]] std::vector<Score> markers() const {
    std::vector<Score> result;
    for (const auto& values : scores) {
      result.push_back({values, HigherMeans::success});
    }
    return result;
  }
};

double wins(double x, double y) { return x > y ? 1.0 : (x == y ? 0.5 : 0.0); }

/// Per cluster: m, n and the sums of V10 and V01, straight from the definition.
struct ClusterSums {
  std::vector<double> m, n, v10, v01;
  double M = 0.0, N = 0.0, area = 0.0;
};

ClusterSums cluster_sums(const Data& data, std::size_t marker, std::size_t clusters) {
  ClusterSums sums;
  for (auto* v : {&sums.m, &sums.n, &sums.v10, &sums.v01}) {
    v->assign(clusters, 0.0);
  }
  for (const double y : data.success) {
    (y == 1.0 ? sums.M : sums.N) += 1.0;
  }
  const auto& x = data.scores[marker];
  for (std::size_t i = 0; i < x.size(); ++i) {
    (data.success[i] == 1.0 ? sums.m : sums.n)[data.cluster[i]] += 1.0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (data.success[i] == 1.0 && data.success[j] == 0.0) {
        const double psi = wins(x[i], x[j]);
        sums.v10[data.cluster[i]] += psi / sums.N;
        sums.v01[data.cluster[j]] += psi / sums.M;
        sums.area += psi / (sums.M * sums.N);
      }
    }
  }
  return sums;
}

/// Obuchowski (1997): S10 / M + S01 / N + (S11 + S11') / (M N).
double paper_covariance(const ClusterSums& a, const ClusterSums& b) {
  const std::size_t clusters = a.m.size();
  double I10 = 0.0, I01 = 0.0, s10 = 0.0, s01 = 0.0, s11 = 0.0, s11_other = 0.0;
  for (std::size_t c = 0; c < clusters; ++c) {
    I10 += a.m[c] > 0.0 ? 1.0 : 0.0;
    I01 += a.n[c] > 0.0 ? 1.0 : 0.0;
    const double xa = a.v10[c] - a.m[c] * a.area;
    const double ya = a.v01[c] - a.n[c] * a.area;
    const double xb = b.v10[c] - b.m[c] * b.area;
    const double yb = b.v01[c] - b.n[c] * b.area;
    s10 += xa * xb;
    s01 += ya * yb;
    s11 += xa * yb;
    s11_other += ya * xb;
  }
  const auto I = static_cast<double>(clusters);
  s10 *= I10 / ((I10 - 1.0) * a.M);
  s01 *= I01 / ((I01 - 1.0) * a.N);
  s11 *= I / (I - 1.0);
  s11_other *= I / (I - 1.0);
  return s10 / a.M + s01 / a.N + (s11 + s11_other) / (a.M * a.N);
}

Data random_data(std::uint64_t seed, std::size_t clusters, std::size_t markers) {
  table::RandomStream random(seed, 2, 0);
  Data data;
  data.scores.resize(markers);
  for (std::size_t c = 0; c < clusters; ++c) {
    const std::uint32_t rows = 1 + random.below(5);
    const double shift = random.below(4);
    for (std::uint32_t i = 0; i < rows; ++i) {
      data.success.push_back(random.below(3) == 0 ? 0 : 1);
      data.cluster.push_back(static_cast<std::uint32_t>(c));
      for (auto& score : data.scores) {
        score.push_back(shift + random.below(4) + data.success.back());
      }
    }
  }
  // Both classes in two clusters at least.
  data.success[0] = 0;
  data.success.back() = 0;
  data.success.insert(data.success.end(), {1, 1});
  data.cluster.insert(data.cluster.end(), {0, 1});
  for (auto& score : data.scores) {
    score.insert(score.end(), {3.0, 5.0});
  }
  return data;
}

TEST(ClusteredAuc, EqualsTheAlgebraOfTwoClusters) {
  // Cluster 1: success 3, failure 1; cluster 2: success 2, failure 2. V10 = {1, 0.75},
  // V01 = {1, 0.75}, AUC = 0.875. Every sum is +-0.125, so S10 = S01 = 2/(1*2) * 2/64 = 1/32 and
  // S11 = 2/1 * 2/64 = 1/16: variance 1/64 + 1/64 + 2/4 * 1/16 = 1/16, twice the plain one.
  const std::vector<double> score{3, 2, 1, 2};
  const std::vector<double> success{1, 1, 0, 0};
  const std::vector<std::uint32_t> cluster{7, 2, 7, 2};
  const AucEstimate estimate = auc(score, success, HigherMeans::success, {0.95, cluster});
  EXPECT_EQ(estimate.auc, 0.875);
  EXPECT_EQ(estimate.variance, 0.0625);
  EXPECT_EQ(estimate.clusters, 2U);
  EXPECT_TRUE(has(estimate.conditions, ConditionKind::few_clusters));
}

TEST(ClusteredAuc, EqualsThePaperOnRandomTiedScores) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t clusters = 3 + seed % 11;
    const Data data = random_data(seed, clusters, 3);
    const JointAuc joint = joint_auc(data.markers(), data.success, {0.9, data.cluster});
    ASSERT_TRUE(joint.covariance.has_value());
    std::vector<ClusterSums> sums;
    for (std::size_t k = 0; k < 3; ++k) {
      sums.push_back(cluster_sums(data, k, clusters));
      EXPECT_NEAR(joint.markers[k].auc.value(), sums[k].area, 1e-13);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_NEAR((*joint.covariance)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                    paper_covariance(sums[i], sums[j]),
                    1e-14);
      }
    }
    const AucDifference difference = auc_contrast(joint, 0, 2);
    EXPECT_NEAR(difference.variance.value(),
                paper_covariance(sums[0], sums[0]) + paper_covariance(sums[2], sums[2]) -
                    2.0 * paper_covariance(sums[0], sums[2]),
                1e-14);
  }
}

TEST(ClusteredAuc, OfSingleRowsIsDeLong) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Data data = random_data(seed, 12, 2);
    for (std::size_t row = 0; row < data.cluster.size(); ++row) {
      data.cluster[row] = static_cast<std::uint32_t>(1000 - row);
    }
    const JointAuc plain = joint_auc(data.markers(), data.success);
    const JointAuc clustered = joint_auc(data.markers(), data.success, {0.95, data.cluster});
    EXPECT_LT((*plain.covariance - *clustered.covariance).cwiseAbs().maxCoeff(), 1e-16);
    EXPECT_NEAR(auc_contrast(plain, 0, 1).p_value.value(),
                auc_contrast(clustered, 0, 1).p_value.value(),
                1e-13);
  }
}

TEST(ClusteredAuc, DoesNotCareAboutTheOrderOfRowsOrTheNamesOfClusters) {
  const Data data = random_data(3, 9, 2);
  Data turned = data;
  for (auto& score : turned.scores) {
    std::reverse(score.begin(), score.end());
  }
  std::reverse(turned.success.begin(), turned.success.end());
  std::reverse(turned.cluster.begin(), turned.cluster.end());
  for (std::uint32_t& code : turned.cluster) {
    code = 77 - 3 * code;
  }
  const JointAuc a = joint_auc(data.markers(), data.success, {0.95, data.cluster});
  const JointAuc b = joint_auc(turned.markers(), turned.success, {0.95, turned.cluster});
  EXPECT_EQ(a.markers[1].auc, b.markers[1].auc);
  EXPECT_LT((*a.covariance - *b.covariance).cwiseAbs().maxCoeff(), 1e-16);
}

TEST(ClusteredAuc, NamesWhatItCannotEstimate) {
  const std::vector<double> score{3, 2, 1, 2};
  const std::vector<double> success{1, 1, 0, 0};
  const AucEstimate one =
      auc(score, success, HigherMeans::success, {0.95, std::vector<std::uint32_t>(4, 5)});
  EXPECT_EQ(one.auc, 0.875);
  EXPECT_FALSE(one.variance.has_value());
  EXPECT_TRUE(has(one.conditions, ConditionKind::one_cluster));

  const std::vector<std::uint32_t> failures_together{1, 2, 3, 3};
  const AucEstimate together = auc(score, success, HigherMeans::success, {0.95, failures_together});
  EXPECT_FALSE(together.interval.has_value());
  ASSERT_TRUE(has(together.conditions, ConditionKind::one_cluster));
  EXPECT_EQ(together.conditions[0].detail, "all failures are in it");

  const std::vector<std::uint32_t> missing{1, table::Factor::kMissing, 2, 3};
  EXPECT_EQ(auc(score, success, HigherMeans::success, {0.95, missing}).missing, 1U);
  EXPECT_THROW(static_cast<void>(auc(
                   score, success, HigherMeans::success, {0.95, std::vector<std::uint32_t>(3, 5)})),
               std::invalid_argument);
}

TEST(JointAuc, GivesEachMarkerAsItIsAlone) {
  const Data data = random_data(5, 20, 4);
  const JointAuc joint = joint_auc(data.markers(), data.success);
  for (std::size_t k = 0; k < 4; ++k) {
    const AucEstimate alone = auc(data.scores[k], data.success, HigherMeans::success);
    EXPECT_EQ(joint.markers[k].auc, alone.auc);
    EXPECT_EQ(joint.markers[k].variance, alone.variance);
  }
  EXPECT_THROW(static_cast<void>(auc_contrast(joint, 0, 4)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(joint_auc({}, data.success)), std::invalid_argument);
}

TEST(AucContrast, HasOneSidedAlternatives) {
  const Data data = random_data(6, 30, 2);
  const JointAuc joint = joint_auc(data.markers(), data.success);
  const double two_sided = auc_contrast(joint, 0, 1).p_value.value();
  const double less = auc_contrast(joint, 0, 1, Alternative::less).p_value.value();
  const double greater = auc_contrast(joint, 0, 1, Alternative::greater).p_value.value();
  EXPECT_NEAR(less + greater, 1.0, 1e-15);
  EXPECT_NEAR(two_sided, 2.0 * std::min(less, greater), 1e-15);
  EXPECT_EQ(auc_contrast(joint, 1, 0, Alternative::less).p_value.value(), greater);
}

}  // namespace
}  // namespace tcert::statistics
