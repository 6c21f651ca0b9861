// A short part of the study of the bound of ray calibrations: the law of its coverage is exact.

#include "analysis/study/coverage/ray_study.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tcert::study::coverage {
namespace {

TEST(RayStudy, CoversNewDaysAsTheExactLawSays) {
  std::uint32_t stream = 900;
  for (const RayScenario& scenario : ray_scenarios()) {
    std::vector<RayCalibrated> calibrations;
    for (std::uint64_t i = 0; i < 500; ++i) {
      calibrations.push_back(calibrate_one(scenario, stream, 50, 1, i));
    }
    ++stream;
    const RayCoverage row = summarise(scenario, 50, calibrations);
    EXPECT_GE(row.expected, row.promised - 1e-12);
    EXPECT_NEAR(row.covered, row.expected, 4.0 * row.monte_carlo_se) << row.scenario;
    EXPECT_LT(row.distance, 1.95) << row.scenario << ": passed in 1 of 1000 (Kolmogorov)";
    EXPECT_NEAR(row.low, row.expected_low, 0.05) << row.scenario;
    EXPECT_GT(row.mean_quantile_m, 0.006) << "more than the noise of one tick";
  }
}

TEST(RayStudy, DrawsDaysThatDoNotDependOnHowManyAreAskedFor) {
  const RayPairs some = simulate_ray_days(3, 1, 5, 2);
  const RayPairs more = simulate_ray_days(2, 4, 5, 2);
  std::vector<RayPair> of_day;
  for (const RayPair& pair : more.pairs) {
    if (more.days[pair.day] == "3") {
      of_day.push_back(pair);
    }
  }
  ASSERT_EQ(of_day.size(), some.pairs.size());
  for (std::size_t i = 0; i < of_day.size(); ++i) {
    EXPECT_EQ(of_day[i].bend_rad, some.pairs[i].bend_rad);
    EXPECT_EQ(of_day[i].clearance_m, some.pairs[i].clearance_m);
  }
}

}  // namespace
}  // namespace tcert::study::coverage
