#include <statistics/basics/binomial_interval.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/basics/normal.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

/// Pr(at most k of n) by adding up.
double binomial_cdf(std::size_t k, std::size_t n, double p) {
  double sum = 0.0;
  for (std::size_t i = 0; i <= k; ++i) {
    const auto a = static_cast<double>(i);
    const auto b = static_cast<double>(n - i);
    sum += std::exp(std::lgamma(a + b + 1.0) - std::lgamma(a + 1.0) - std::lgamma(b + 1.0) +
                    a * std::log(p) + b * std::log1p(-p));
  }
  return sum;
}

TEST(ClopperPearson, EndsHaveTheTailsOfTheDefinition) {
  for (const auto& [k, n] : {std::pair<std::size_t, std::size_t>{1, 9}, {4, 9}, {30, 200}}) {
    const Interval interval = clopper_pearson(k, n, 0.9).value();
    EXPECT_NEAR(binomial_cdf(k, n, interval.high), 0.05, 1e-12);
    EXPECT_NEAR(1.0 - binomial_cdf(k - 1, n, interval.low), 0.05, 1e-12);
    EXPECT_NEAR(binomial_cdf(k, n, *clopper_pearson_upper(k, n, 0.95)), 0.05, 1e-12);
  }
}

TEST(ClopperPearson, AtTheEnds) {
  EXPECT_EQ(clopper_pearson(0, 10)->low, 0.0);
  EXPECT_NEAR(clopper_pearson(0, 10)->high, 1.0 - std::pow(0.025, 0.1), 1e-15);
  EXPECT_EQ(clopper_pearson(10, 10)->high, 1.0);
  EXPECT_EQ(clopper_pearson_upper(10, 10), 1.0);
  // The rule of three.
  EXPECT_NEAR(*clopper_pearson_upper(0, 1000), 0.003, 1e-5);
  EXPECT_FALSE(clopper_pearson(0, 0).has_value());
  EXPECT_FALSE(wilson(0, 0).has_value());
}

TEST(Wilson, EndsAreWhereTheScoreTestIsAtItsLevel) {
  for (const auto& [k, n] : {std::pair<std::size_t, std::size_t>{0, 9}, {4, 9}, {30, 200}}) {
    const Interval interval = wilson(k, n).value();
    const auto trials = static_cast<double>(n);
    const double share = static_cast<double>(k) / trials;
    const double z =
        std::abs(share - interval.high) / std::sqrt(interval.high * (1.0 - interval.high) / trials);
    EXPECT_NEAR(z, normal_factor(0.95), 1e-12);
  }
  EXPECT_EQ(wilson(0, 9)->low, 0.0);
  EXPECT_EQ(wilson(9, 9)->high, 1.0);
}

TEST(BinomialIntervals, RefuseMisuse) {
  EXPECT_THROW(static_cast<void>(wilson(2, 1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(clopper_pearson(1, 2, 1.0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(clopper_pearson_upper(1, 2, 0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
