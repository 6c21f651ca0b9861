#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <statistics/equivalence/paired_proportions.hpp>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {
namespace {

/// binom.test(lost, lost + won)$p.value of R 4.2.2.
TEST(PairedProportions, McNemarIsTheExactBinomialTest) {
  EXPECT_NEAR(mcnemar_exact_p(10, 7), 0.62905883789062511, 1e-14);
  EXPECT_NEAR(mcnemar_exact_p(0, 5), 0.0625, 1e-15);
  EXPECT_NEAR(mcnemar_exact_p(3, 12), 0.035156250000000014, 1e-15);
  EXPECT_EQ(mcnemar_exact_p(1, 1), 1.0);
  EXPECT_EQ(mcnemar_exact_p(0, 0), 1.0);
  EXPECT_NEAR(mcnemar_exact_p(169, 0) / 2.6727647100921867e-51, 1.0, 1e-12);
}

std::vector<double> differences() {
  return {0,  0, 0,  1, 0, -1, 1, 0, 0,  0, 0, 0,  0, 0, -1, 0, 0,  1, 0, -1,
          1,  0, 0,  0, 0, 0,  0, 0, -1, 0, 0, 0,  0, 0, -1, 0, -1, 0, 0, 0,
          -1, 0, -1, 0, 0, -1, 0, 0, 0,  0, 0, -1, 0, 0, 0,  0, 0,  0, 0, 0};
}

/// set.seed(1); lm(d ~ 1) with sandwich::vcovCL(cluster = rep(1:12, 5), type = "HC0"), t of 11.
TEST(PairedProportions, TheClusteredMeanIsRs) {
  std::vector<std::uint32_t> clusters;
  for (std::uint32_t i = 0; i < 60; ++i) {
    clusters.push_back(i % 12);
  }
  const auto mean = clustered_mean(differences(), clusters);
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->value, -0.1, 1e-15);
  EXPECT_EQ(mean->clusters, 12U);
  EXPECT_NEAR(mean->standard_error.value(), 0.046056618647183821, 1e-15);
  ASSERT_TRUE(mean->interval);
  EXPECT_NEAR(mean->interval->low, -0.2013699341664514642, 1e-12);
  EXPECT_NEAR(mean->interval->high, 0.0013699341664514531, 1e-12);
}

TEST(PairedProportions, OneClusterOrNoSpreadHasNoInterval) {
  const std::vector<double> same(10, 0.0);
  const std::vector<std::uint32_t> one(10, 0);
  std::vector<std::uint32_t> two = one;
  two.back() = 1;
  EXPECT_FALSE(clustered_mean(same, one)->standard_error);
  EXPECT_FALSE(clustered_mean(same, two)->interval);
  EXPECT_FALSE(clustered_mean({}, {}));
  EXPECT_THROW(static_cast<void>(clustered_mean(same, {})), std::invalid_argument);
}

/// (qnorm(.95) + qnorm(.8))^2 * 0.2 / 0.05^2 = 494.6.
TEST(PairedProportions, PairsThatWouldBeNeeded) {
  EXPECT_EQ(pairs_for_non_inferiority(0.2, 0.05), 495U);
  EXPECT_FALSE(pairs_for_non_inferiority(0.0, 0.05));
  EXPECT_THROW(static_cast<void>(pairs_for_non_inferiority(0.2, 0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
