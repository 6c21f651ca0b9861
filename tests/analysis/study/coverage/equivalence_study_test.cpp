// A small part of the study of equivalence: that its truth is true and its rates sane.

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/equivalence/scores_by_group.hpp>

#include "analysis/study/coverage/coverage_study.hpp"
#include "analysis/study/coverage/equivalence_study.hpp"

namespace tcert::study {
namespace {

TEST(EquivalenceStudy, KnowsItsTruth) {
  EXPECT_NEAR(coverage::true_auc(coverage::correlation_of(0.7)), 0.7, 1e-4);
  // One trial a day and lighting: independent within each.
  coverage::LightingScenario scenario;
  scenario.days = 60000;
  scenario.trials_per_lighting = 1;
  const double better = coverage::correlation_of(0.76);
  const double worse = coverage::correlation_of(0.6);
  const coverage::LightingStudy study =
      coverage::simulate(scenario, {better, better, worse}, 3, 1, 0);
  const std::vector<statistics::GroupScore> scores =
      statistics::auc_by_group({study.predictor, statistics::HigherMeans::success},
                               study.success,
                               study.lighting,
                               study.day);
  EXPECT_NEAR(*scores[0].value, 0.76, 4.0 * *scores[0].standard_error + 1e-4);
  EXPECT_NEAR(*scores[2].value, 0.6, 4.0 * *scores[2].standard_error + 1e-4);
}

coverage::EquivalenceRates rates_of(const coverage::LightingScenario& scenario,
                                    std::uint32_t stream) {
  const coverage::EquivalenceSets sets(scenario, stream, 1);
  coverage::EquivalenceTally tally;
  for (std::uint64_t set = 0; set < 150; ++set) {
    tally.add(sets(set));
  }
  return tally.rates();
}

TEST(EquivalenceStudy, FindsWhatIsThere) {
  coverage::LightingScenario equal;
  equal.icc = 0.2;
  equal.margin = 0.4;
  const coverage::EquivalenceRates same = rates_of(equal, 300);
  EXPECT_GE(same.tested, 145U);
  EXPECT_GT(same.equivalent, 0.9);
  EXPECT_LT(same.different, 0.25);
  EXPECT_NEAR(same.mean_error, same.true_error, 0.2 * same.true_error);
  coverage::LightingScenario apart = equal;
  apart.margin = 0.22;
  apart.difference = 0.22;
  const coverage::EquivalenceRates at_margin = rates_of(apart, 301);
  EXPECT_LT(at_margin.equivalent, 0.12);  // 5 % nominal
  EXPECT_GT(at_margin.different, 0.5);
}

}  // namespace
}  // namespace tcert::study
