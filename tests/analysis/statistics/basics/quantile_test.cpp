#include <statistics/basics/quantile.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
  // n = 5, p = 0.1: index 1 + 4 * 0.1 = 1.4, so 0.6 of the smallest and 0.4 of the next.
  const std::vector<double> sample{50, 10, 40, 20, 30};
  EXPECT_DOUBLE_EQ(quantile(sample, 0.10).value(), 0.6 * 10 + 0.4 * 20);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.25).value(), 20);
  // n = 11: index 2 exactly.
  const std::vector<double> eleven{11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1};
  EXPECT_DOUBLE_EQ(quantile(eleven, 0.10).value(), 2);
}

TEST(Quantile, ReachesBothEnds) {
  const std::vector<double> sample{3, 1, 2};
  EXPECT_EQ(quantile(sample, 0.0), 1.0);
  EXPECT_EQ(quantile(sample, 1.0), 3.0);
  EXPECT_EQ(quantile(std::vector<double>{7.0}, 0.10), 7.0);
}

TEST(Quantile, KeepsTheValueOfTies) {
  const std::vector<double> sample{0.1, 0.1, 0.1, 0.1, 9};
  EXPECT_EQ(quantile(sample, 0.60), 0.1);
  EXPECT_EQ(quantile(std::vector<double>(7, 0.3), 0.10), 0.3);
}

TEST(Quantile, IsMissingForNothingAndForNan) {
  EXPECT_EQ(quantile({}, 0.5), std::nullopt);
  EXPECT_EQ(quantile(std::vector<double>{1, kNan, 3}, 0.5), std::nullopt);
}

TEST(Quantile, TakesInfinitiesAsValues) {
  EXPECT_EQ(quantile(std::vector<double>{-kInf, -kInf, 1, 2}, 0.10), -kInf);
  EXPECT_EQ(quantile(std::vector<double>{-kInf, 1, 2}, 1.0), 2.0);
  EXPECT_EQ(quantile(std::vector<double>{-kInf, kInf}, 0.5), std::nullopt);
}

TEST(Quantile, RefusesAProbabilityOutsideTheUnitInterval) {
  const std::vector<double> sample{1, 2};
  EXPECT_THROW(static_cast<void>(quantile(sample, -0.01)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantile(sample, 1.01)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantile(sample, kNan)), std::invalid_argument);
}

TEST(Quantile, EqualsTheSortedDefinitionOnRandomTiedSamples) {
  table::RandomStream random(1, 0, 0);
  for (int round = 0; round < 500; ++round) {
    SCOPED_TRACE(round);
    std::vector<double> sample(1 + random.below(30));
    for (double& x : sample) {
      x = static_cast<double>(random.below(8)) / 7.0;
    }
    const double p = random.uniform();
    std::vector<double> sorted = sample;
    std::sort(sorted.begin(), sorted.end());
    const double index = static_cast<double>(sorted.size() - 1) * p;
    const auto below = static_cast<std::size_t>(index);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double expected =
        sorted[below] + (index - static_cast<double>(below)) * (sorted[above] - sorted[below]);
    EXPECT_NEAR(quantile(sample, p).value(), expected, 1e-13);
  }
}

TEST(Median, AveragesTheTwoMiddleValues) {
  EXPECT_EQ(median(std::vector<double>{4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median(std::vector<double>{5, 1, 3}), 3.0);
}

}  // namespace
}  // namespace tcert::statistics
