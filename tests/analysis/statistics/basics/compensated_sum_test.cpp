#include <statistics/basics/compensated_sum.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <table/random.hpp>

namespace tcert::statistics {
namespace {

TEST(CompensatedSum, KeepsWhatAPlainSumLoses) {
  CompensatedSum sum;
  double plain = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    sum.add(0.1);
    plain += 0.1;
  }
  EXPECT_NEAR(sum.value(), 100'000.0, 1e-10);
  EXPECT_GT(std::abs(plain - 100'000.0), 1e-7);
}

TEST(CompensatedSum, EqualsASumOfWiderNumbers) {
  table::RandomStream random(7, 1, 0);
  for (int round = 0; round < 20; ++round) {
    CompensatedSum sum;
    long double wide = 0.0L;
    for (int i = 0; i < 10'000; ++i) {
      const double term = std::exp(40.0 * (random.uniform() - 0.5)) * (i % 2 == 0 ? 1.0 : -1.0);
      sum.add(term);
      wide += static_cast<long double>(term);
    }
    EXPECT_NEAR(sum.value(), static_cast<double>(wide), 1e-15 * std::abs(sum.value()) + 1e-9);
  }
}

TEST(CompensatedSum, OfTermsThatAreNotFiniteIsNotFinite) {
  CompensatedSum sum;
  sum.add(1.0);
  sum.add(-std::numeric_limits<double>::infinity());
  EXPECT_EQ(sum.value(), -std::numeric_limits<double>::infinity());
  sum.add(std::nan(""));
  EXPECT_TRUE(std::isnan(sum.value()));
}

}  // namespace
}  // namespace tcert::statistics
