#include <statistics/basics/student_t.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <statistics/basics/few_clusters.hpp>

namespace tcert::statistics {
namespace {

TEST(StudentT, EqualsR) {
  EXPECT_NEAR(t_factor(0.95, 1), 12.706204736175, 1e-10);
  EXPECT_NEAR(t_factor(0.95, 5), 2.570581835636, 1e-11);
  EXPECT_NEAR(t_factor(0.9, 12.3), 1.778672546238, 1e-11);
  EXPECT_NEAR(t_p_value(-5.134, 1, Alternative::two_sided), 0.122467328764, 1e-11);
  EXPECT_NEAR(t_p_value(1.2, 4.5, Alternative::less), 0.855261472579, 1e-11);
  EXPECT_NEAR(t_p_value(1.2, 4.5, Alternative::greater), 1.0 - 0.855261472579, 1e-11);
}

TEST(StudentT, OfTwoClustersIsCauchys) {
  const ClusterT two = by_cluster_t(3.0, 2.0, 1.5, 2, 0.95);
  EXPECT_NEAR(two.p_value.value(), 1.0 - 2.0 / std::numbers::pi * std::atan(1.5), 1e-12);
  EXPECT_NEAR(two.interval->low, 3.0 - 2.0 * 12.706204736175, 1e-9);
  EXPECT_NEAR(two.interval->high, 3.0 + 2.0 * 12.706204736175, 1e-9);
  EXPECT_FALSE(by_cluster_t(3.0, 2.0, {}, 2, 0.95).p_value.has_value());
  for (const ClusterT& none : {by_cluster_t(3.0, 2.0, 1.5, 1, 0.95),
                               by_cluster_t(3.0, {}, 1.5, 9, 0.95),
                               by_cluster_t({}, 2.0, 1.5, 9, 0.95),
                               by_cluster_t(3.0, 0.0, 1.5, 9, 0.95)}) {
    EXPECT_FALSE(none.p_value.has_value());
    EXPECT_FALSE(none.interval.has_value());
  }
}

TEST(FewClusters, AreANoteBelowThirtyAndAWarningBelowTenOrWithoutFullRank) {
  EXPECT_FALSE(few_clusters(0).has_value());
  EXPECT_FALSE(few_clusters(1).has_value()) << "that is one_cluster";
  EXPECT_FALSE(few_clusters(30).has_value());
  EXPECT_EQ(few_clusters(29)->severity, ConditionSeverity::note);
  EXPECT_EQ(few_clusters(29)->detail, "29 clusters, fewer than 30");
  EXPECT_EQ(few_clusters(10)->severity, ConditionSeverity::note);
  EXPECT_EQ(few_clusters(9)->severity, ConditionSeverity::warning);
  EXPECT_EQ(few_clusters(9, 0, "dark")->detail, "dark: 9 clusters, fewer than 10");
  EXPECT_EQ(few_clusters(6, 0, "", kTooFewClusters)->severity, ConditionSeverity::note);
  EXPECT_EQ(few_clusters(5, 0, "", kTooFewClusters)->detail, "5 clusters, fewer than 6");
  EXPECT_EQ(few_clusters(12, 12)->severity, ConditionSeverity::warning);
  EXPECT_EQ(few_clusters(12, 11)->severity, ConditionSeverity::note);
  EXPECT_EQ(few_clusters(40, 40)->detail,
            "40 clusters and no more than the 40 coefficients, so that their covariance has no "
            "full rank");
  EXPECT_FALSE(few_clusters(40, 39).has_value());
}

}  // namespace
}  // namespace tcert::statistics
