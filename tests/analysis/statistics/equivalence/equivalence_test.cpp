#include <statistics/equivalence/equivalence.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <statistics/basics/normal.hpp>
#include <statistics/equivalence/range_permutation.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

GroupEstimates three(double spread, double error) {
  GroupEstimates groups;
  groups.names = {"Dark", "Indoor", "Outdoor"};
  groups.values = Eigen::Vector3d(0.8, 0.8 + spread, 0.8 - spread);
  groups.covariance = error * error * Eigen::Matrix3d::Identity();
  return groups;
}

TEST(Equivalence, ByHand) {
  const Equivalence result = equivalence(three(0.01, 0.01));
  const double half = 1.6448536269514722 * std::sqrt(2.0) * 0.01;
  ASSERT_EQ(result.pairs.size(), 3U);
  EXPECT_NEAR(result.pairs[2].difference, 0.02, 1e-15);
  EXPECT_NEAR(result.pairs[2].interval.high, 0.02 + half, 1e-15);
  EXPECT_NEAR(*result.smallest_margin, 0.02 + half, 1e-15);
  EXPECT_EQ(*result.equivalent, 0.02 + half < 0.05);
  EXPECT_NEAR(*result.p_value, normal_cdf(-0.03 / (std::sqrt(2.0) * 0.01)), 1e-15);
  EXPECT_NEAR(*result.range, 0.02, 1e-15);
  // Independent with equal variances: the sum of squares about the mean over the variance.
  EXPECT_NEAR(result.heterogeneity->statistic, 2.0, 1e-12);
  EXPECT_EQ(result.heterogeneity->df, 2U);
}

TEST(Equivalence, ThePowerMarginHasThatPower) {
  GroupEstimates two = three(0.0, 0.03);
  two.names.resize(2);
  two.values = Eigen::VectorXd(two.values.head(2));
  two.covariance = Eigen::MatrixXd(two.covariance.topLeftCorner(2, 2));
  const double margin = equivalence(two).margin_with_power.value();
  EXPECT_NEAR(equivalence_power(0.0, std::sqrt(2.0) * 0.03, margin, 0.05), 0.8, 1e-12);
  // At the margin itself the test is at its level where the other side is far.
  EXPECT_NEAR(equivalence_power(1.0, 0.01, 1.0, 0.05), 0.05, 1e-12);
  EXPECT_EQ(equivalence_power(0.0, 1.0, 1.0, 0.05), 0.0);
  const Equivalence all = equivalence(three(0.0, 0.03));
  EXPECT_NEAR(*all.margin_with_power,
              std::sqrt(2.0) * 0.03 * (normal_quantile(0.95) + normal_quantile(1.0 - 0.1 / 3.0)),
              1e-15);
}

TEST(Equivalence, TheOrderOfTheGroupsDoesNotMatter) {
  GroupEstimates groups = three(0.03, 0.02);
  groups.covariance(0, 1) = groups.covariance(1, 0) = 1e-4;
  groups.covariance(2, 2) = 9e-4;
  GroupEstimates turned = groups;
  const Eigen::Vector3i order(2, 0, 1);
  turned.values = Eigen::VectorXd(groups.values(order));
  turned.covariance = Eigen::MatrixXd(groups.covariance(order, order));
  const Equivalence one = equivalence(groups);
  const Equivalence two = equivalence(turned);
  EXPECT_NEAR(one.heterogeneity->statistic, two.heterogeneity->statistic, 1e-12);
  EXPECT_NEAR(*one.smallest_margin, *two.smallest_margin, 1e-15);
  EXPECT_NEAR(*one.p_value, *two.p_value, 1e-15);
}

TEST(Equivalence, NamesWhatHasNoTest) {
  GroupEstimates one = three(0.0, 0.1);
  one.names.resize(1);
  one.values = Eigen::VectorXd(one.values.head(1));
  one.covariance = Eigen::MatrixXd(one.covariance.topLeftCorner(1, 1));
  const Equivalence single = equivalence(one);
  EXPECT_TRUE(has(single.conditions, ConditionKind::one_group));
  EXPECT_FALSE(single.equivalent.has_value());
  // Two clusters, three groups: rank 1.
  GroupEstimates singular = three(0.01, 0.1);
  const Eigen::Vector3d line(0.1, 0.2, -0.1);
  singular.covariance = line * line.transpose();
  const Equivalence result = equivalence(singular);
  EXPECT_TRUE(has(result.conditions, ConditionKind::singular_covariance));
  EXPECT_FALSE(result.heterogeneity.has_value());
  EXPECT_TRUE(result.equivalent.has_value());
}

TEST(Equivalence, RefusesMisuse) {
  EquivalenceOptions options;
  options.margin = 0.0;
  EXPECT_THROW(static_cast<void>(equivalence(three(0.0, 0.1), options)), std::invalid_argument);
  options = {};
  options.alpha = 0.5;
  EXPECT_THROW(static_cast<void>(equivalence(three(0.0, 0.1), options)), std::invalid_argument);
  GroupEstimates nan = three(0.0, 0.1);
  nan.values[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(equivalence(nan)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(non_inferiority(0.1, 0.0, 0.05)), std::invalid_argument);
}

TEST(NonInferiority, OfADifferenceIsOneSided) {
  const NonInferiority result = non_inferiority(0.01, 0.02, 0.05);
  EXPECT_NEAR(result.upper, 0.01 + 1.6448536269514722 * 0.02, 1e-15);
  EXPECT_TRUE(result.non_inferior);
  EXPECT_LT(result.p_value, 0.05);
  EXPECT_FALSE(non_inferiority(0.03, 0.02, 0.05).non_inferior);
}

/// Range of the means of `values` by label.
RangeKernel range_of_means(const std::vector<double>& values, std::size_t groups) {
  return [values, groups](std::span<const std::uint32_t> labels) {
    std::vector<double> sum(groups, 0.0);
    std::vector<double> count(groups, 0.0);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      sum[labels[i]] += values[i];
      count[labels[i]] += 1.0;
    }
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t g = 0; g < groups; ++g) {
      low = std::min(low, sum[g] / count[g]);
      high = std::max(high, sum[g] / count[g]);
    }
    return high - low;
  };
}

TEST(RangeUnderEquality, OfTwoPairsIsKnown) {
  // Each cluster's labels stand as they are or exchanged: means differ by |+-1 +-3| / 2.
  const std::vector<double> values{0, 1, 0, 3};
  const std::vector<std::uint32_t> labels{0, 1, 0, 1};
  const std::vector<std::uint32_t> cluster{7, 7, 9, 9};
  PermutationOptions options;
  options.permutations = 20000;
  const RangeUnderEquality result = range_under_equality(
      labels, cluster, [&] { return range_of_means(values, 2); }, options);
  EXPECT_EQ(result.observed, 2.0);
  EXPECT_NEAR(*result.expected, 1.5, 0.02);  // 2 or 1, each with probability 1/2
  EXPECT_NEAR(*result.p_value, 0.5, 0.02);
  EXPECT_EQ(result.failed, 0U);
}

TEST(RangeUnderEquality, CountsFailuresAndRefusesMisuse) {
  const std::vector<std::uint32_t> labels{0, 1};
  const auto none = [] {
    return RangeKernel([](std::span<const std::uint32_t>) { return std::nan(""); });
  };
  PermutationOptions options;
  options.permutations = 5;
  const RangeUnderEquality result = range_under_equality(labels, labels, none, options);
  EXPECT_EQ(result.failed, 5U);
  EXPECT_FALSE(result.expected.has_value());
  options.permutations = 0;
  EXPECT_THROW(static_cast<void>(range_under_equality(labels, labels, none, options)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(range_under_equality(labels, {}, none)), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
