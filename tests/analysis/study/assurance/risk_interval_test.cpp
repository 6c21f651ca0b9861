#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <statistics/basics/binomial_interval.hpp>
#include <tcert/risk_intensity.hpp>

namespace tcert {
namespace {

double intensity_of(double share, double error_m2) {
  return share < 1.0 ? -std::log(1.0 - share) / error_m2 : std::numeric_limits<double>::infinity();
}

// Of cells of known intensity: the exact interval of h/(h + m) through the logarithm covers, the
// published one does not where hits are few.
TEST(RiskInterval, TheExactOneCoversAndThePublishedOneDoesNot) {
  constexpr double kError = 0.04;
  constexpr int kTrials = 20'000;
  std::mt19937 random(1);
  for (const double share : {0.01, 0.1, 0.5}) {
    for (const int looks : {10, 50, 400}) {
      const double truth = intensity_of(share, kError);
      int published = 0;
      int exact = 0;
      for (int i = 0; i < kTrials; ++i) {
        const int hits = std::binomial_distribution<int>(looks, share)(random);
        const IntensityRange range = lambda_interval(
            {static_cast<double>(hits), static_cast<double>(looks - hits), kError}, 0.99, 0.9999);
        published += range.low <= truth && truth <= range.high ? 1 : 0;
        const auto of_share = statistics::clopper_pearson(static_cast<std::size_t>(hits),
                                                          static_cast<std::size_t>(looks));
        exact += intensity_of(of_share->low, kError) <= truth &&
                         truth <= intensity_of(of_share->high, kError)
                     ? 1
                     : 0;
      }
      std::printf("share %.2f, %3d looks: published %.3f, exact %.3f\n",
                  share,
                  looks,
                  static_cast<double>(published) / kTrials,
                  static_cast<double>(exact) / kTrials);
      EXPECT_GE(exact, 0.945 * kTrials) << share << ' ' << looks;
      EXPECT_LT(published, 0.9 * kTrials) << share << ' ' << looks;
    }
  }
}

}  // namespace
}  // namespace tcert
