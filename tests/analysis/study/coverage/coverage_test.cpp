// A small part of the coverage study: that its truth is true and its table sane.

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/concordance/concordance.hpp>
#include <statistics/roc/roc.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

#include "analysis/study/coverage/coverage_study.hpp"

namespace tcert::study {
namespace {

TEST(CoverageStudy, KnowsItsTruth) {
  // One trial a day: 200,000 independent trials.
  const coverage::Study study = coverage::simulate({"", 200000, 1, 0.5}, 3, 1, 0);
  const std::vector<double> outcome(study.success.begin(), study.success.end());
  const statistics::AucEstimate first =
      statistics::auc(study.first, outcome, statistics::HigherMeans::success);
  const statistics::AucEstimate second =
      statistics::auc(study.second, outcome, statistics::HigherMeans::success);
  EXPECT_NEAR(coverage::true_auc(coverage::kFirstCorrelation),
              first.auc.value(),
              4.0 * std::sqrt(first.variance.value()));
  EXPECT_NEAR(coverage::true_auc(coverage::kSecondCorrelation),
              second.auc.value(),
              4.0 * std::sqrt(second.variance.value()));
  const statistics::SurvivalOutcome times{{}, study.time, study.success};
  const std::vector<statistics::Predictor> predictors{
      {"", study.first, statistics::LargerMeans::shorter_time},
      {"", study.second, statistics::LargerMeans::shorter_time}};
  const statistics::ConcordanceResult c = statistics::concordance(times, predictors);
  EXPECT_NEAR(coverage::true_c(coverage::kFirstCorrelation),
              c.estimates[0].c.value(),
              4.0 * c.estimates[0].std_error.value());
  EXPECT_NEAR(coverage::true_c(coverage::kSecondCorrelation),
              c.estimates[1].c.value(),
              4.0 * c.estimates[1].std_error.value());
  EXPECT_NEAR(static_cast<double>(first.failures) / 200000.0, coverage::kFailureShare, 0.003);
  EXPECT_NEAR(coverage::true_auc(0.0), 0.5, 1e-12);
  EXPECT_NEAR(coverage::true_c(0.0), 0.5, 1e-12);
}

TEST(CoverageStudy, SeesThatTrialsOfADayAreNotIndependent) {
  coverage::Options options;
  options.data_sets = 60;
  options.replicates = 199;
  coverage::CoverageTally tally("icc");
  for (std::uint64_t set = 0; set < options.data_sets; ++set) {
    const auto found = coverage::intervals_of({"icc", 22, 30, 0.5}, 2, options, set);
    const std::string text = table::row_text(found);
    ASSERT_EQ(table::row_text(table::from_row<coverage::Intervals>(text)), text);
    tally.add(found);
  }
  const std::vector<coverage::Coverage> rows = tally.rows();
  ASSERT_EQ(rows.size(), 24U);
  for (const coverage::Coverage& row : rows) {
    EXPECT_EQ(row.intervals + row.missing, 60U);
    EXPECT_EQ(row.missing, 0U) << row.method;
    EXPECT_GT(row.mean_width, 0.0);
  }
  // The clustered intervals are wider and cover more.
  EXPECT_GT(rows[1].mean_width, 1.2 * rows[0].mean_width);
  ASSERT_EQ(rows[5].method, "jackknife_days");
  EXPECT_GT(rows[5].mean_width, 1.2 * rows[0].mean_width);
  EXPECT_GE(rows[1].covered, rows[0].covered);
  EXPECT_GE(rows[1].covered, 0.8);
  // Expanded percentiles of 22 days are wider than plain ones, by qnorm(0.01665) / qnorm(0.025) if
  // replicates are normal.
  ASSERT_EQ(rows[3].method, "expanded_days");
  EXPECT_NEAR(rows[3].mean_width / rows[2].mean_width, 1.087, 0.03);
  EXPECT_GE(rows[3].covered, rows[2].covered);
}

}  // namespace
}  // namespace tcert::study
