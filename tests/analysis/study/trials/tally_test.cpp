#include "analysis/study/trials/tally.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <statistics/basics/quantile.hpp>
#include <table/random.hpp>

namespace tcert::study {
namespace {

TEST(Tally, HasTheMedianOfItsSamples) {
  EXPECT_FALSE(Tally().median().has_value());
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    table::RandomStream random(seed, 1, 0);
    std::vector<double> samples(1 + random.below(9));
    for (double& sample : samples) {
      sample = random.below(4);  // few values, so that they tie
    }
    Tally whole;
    whole.add(samples);
    Tally merged;
    Tally rest;
    const std::size_t cut = random.below(static_cast<std::uint32_t>(samples.size()));
    merged.add(std::span(samples).first(cut));
    rest.add(std::span(samples).subspan(cut));
    merged.add(rest);
    EXPECT_EQ(whole.median(), statistics::median(samples));
    EXPECT_EQ(merged.median(), statistics::median(samples));
  }
}

TEST(Tally, LeavesOutWhatIsMissing) {
  Tally tally;
  tally.add(std::array{std::numeric_limits<double>::quiet_NaN(), 2.0, 4.0});
  EXPECT_EQ(tally.median(), 3.0);
}

TEST(Tally, HoldsAnyNumberOfDistinctValues) {
  table::RandomStream random(7, 1, 0);
  std::vector<double> samples(20'000);
  for (double& sample : samples) {
    sample = 0.01 * random.below(5'000) - 20.0;
  }
  Tally tally;
  tally.add(samples);
  const std::span<const double> all(samples);
  Tally merged(all.first(7));
  merged.add(Tally(all.subspan(7)));
  EXPECT_EQ(tally.median(), statistics::median(samples));
  EXPECT_EQ(merged.median(), statistics::median(samples));
}

TEST(Tally, CountsBothZerosAsOne) {
  EXPECT_EQ(Tally(std::array{-0.0, 0.0, -0.0, 1.0, 2.0}).median(), 0.0);
}

}  // namespace
}  // namespace tcert::study
