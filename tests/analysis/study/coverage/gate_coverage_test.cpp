// A small part of the simulation of micro-studies: that it is sane.

#include <gtest/gtest.h>

#include "analysis/study/coverage/gate_study.hpp"

namespace tcert::study {
namespace {

TEST(GateCoverage, SetsOfAFewStudiesCoverTheLargeSamplePoint) {
  coverage::GateOptions options;
  options.studies = 16;
  options.replicates = 199;
  const coverage::GateStudies make(options);
  std::vector<coverage::GateStudy> studies;
  for (std::uint64_t i = 0; i < options.studies; ++i) {
    studies.push_back(make(i));
  }
  const coverage::GateSummary summary = coverage::summarise(studies);
  // Declared at 0; the smaller of a few noisy readings on either side moves it. Of 1,000 studies it
  // is -16.5 mm; the standard error here is about 0.8 mm.
  EXPECT_NEAR(summary.point_m, -0.0165, 0.004);
  EXPECT_GT(summary.slope_per_m, 40.0);
  EXPECT_LE(summary.separated, 2U);
  ASSERT_EQ(summary.methods.size(), 4U);
  for (const coverage::GateCoverage& method : summary.methods) {
    EXPECT_GE(method.covered, 0.8) << method.method;
    EXPECT_LE(method.unbounded, 2U) << method.method;
    EXPECT_GT(method.median_width_m, 0.002);
    EXPECT_LT(method.median_width_m, 0.03);
  }
}

}  // namespace
}  // namespace tcert::study
