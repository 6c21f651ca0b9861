#include <statistics/calibration/conformal.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

TEST(ConformalRank, IsTheSmallestThatCoversOftenEnough) {
  for (const double alpha : {0.01, 0.05, 0.1, 0.2, 0.29, 0.5}) {
    for (std::size_t n = 1; n <= 300; ++n) {
      const auto rank = conformal_rank(n, alpha);
      const bool possible = n >= least_conformal_units(alpha);
      ASSERT_EQ(rank.has_value(), possible) << n << ' ' << alpha;
      if (rank) {
        const auto of = static_cast<double>(n + 1);
        EXPECT_GE(static_cast<double>(*rank) / of, 1.0 - alpha - 1e-9);
        EXPECT_LT(static_cast<double>(*rank - 1) / of, 1.0 - alpha);
        EXPECT_LE(*rank, n);
      }
    }
  }
  EXPECT_EQ(conformal_rank(19, 0.05), 19U);
  EXPECT_EQ(conformal_rank(99, 0.05), 95U);
  EXPECT_EQ(conformal_rank(18, 0.05), std::nullopt);
  EXPECT_EQ(least_conformal_units(0.05), 19U);
  EXPECT_EQ(least_conformal_units(0.1), 9U);
  EXPECT_EQ(least_conformal_alpha(19), 0.05);
}

TEST(ConformalQuantile, IsTheScoreOfThatRank) {
  std::vector<double> scores;
  for (int i = 0; i < 39; ++i) {
    scores.push_back((17 * i) % 39);
  }
  EXPECT_EQ(conformal_quantile(scores, 0.05), 37.0) << "the 38th of 39";
  EXPECT_EQ(conformal_quantile(scores, 0.5), 19.0);
  scores[3] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isinf(conformal_quantile(scores, 0.025).value()));
  EXPECT_EQ(conformal_quantile(scores, 0.02), std::nullopt);
  EXPECT_EQ(conformal_quantile({}, 0.5), std::nullopt);
  scores[0] = std::nan("");
  EXPECT_THROW(static_cast<void>(conformal_quantile(scores, 0.05)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(conformal_quantile(scores, 0.0)), std::invalid_argument);
}

/// Of uniform scores the coverage is the quantile itself: Beta(k, n + 1 - k).
TEST(ConformalQuantile, CoversAsItsLawSays) {
  constexpr std::size_t kRounds = 4000;
  for (const std::size_t n : {19U, 39U, 100U}) {
    const std::size_t rank = conformal_rank(n, 0.05).value();
    std::vector<double> coverage;
    for (std::size_t round = 0; round < kRounds; ++round) {
      table::RandomStream random(3, static_cast<std::uint32_t>(n), round);
      std::vector<double> scores(n);
      for (double& score : scores) {
        score = random.uniform();
      }
      coverage.push_back(conformal_quantile(scores, 0.05).value());
    }
    std::ranges::sort(coverage);
    double distance = 0.0;
    for (std::size_t i = 0; i < kRounds; ++i) {
      const double law = boost::math::ibeta(
          static_cast<double>(rank), static_cast<double>(n + 1 - rank), coverage[i]);
      distance = std::max({distance,
                           std::abs(law - static_cast<double>(i) / kRounds),
                           std::abs(law - static_cast<double>(i + 1) / kRounds)});
    }
    EXPECT_LT(std::sqrt(kRounds) * distance, 1.63) << n << ": Kolmogorov, passed in 1 of 100";
    EXPECT_NEAR(coverage[kRounds / 20], conformal_coverage_quantile(n, rank, 0.05), 0.01);
  }
  EXPECT_NEAR(conformal_coverage_quantile(19, 19, 0.05), std::pow(0.05, 1.0 / 19.0), 1e-12);
}

}  // namespace
}  // namespace tcert::statistics
