// The studies of what the tables of H1, H2 and H3 print: their truths by large samples, and one
// small run of each.

#include "analysis/study/coverage/hypotheses_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/lmm/lmm.hpp>
#include <table/row_text.hpp>

#include "analysis/study/coverage/advance_study.hpp"
#include "analysis/study/h1/log_time.hpp"

namespace tcert::study {
namespace {

TEST(HypothesesStudy, LimitOfR2IsThatOfManyTrials) {
  coverage::Scenario many;
  many.days = 400;
  many.icc = 0.2;
  const coverage::Study study = coverage::simulate(many, 1, 5, 0);
  LogTimes times;
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < study.success.size(); ++i) {
    if (study.success[i] != 0) {
      x.push_back(study.first[i]);
      y.push_back(std::log(study.time[i]));
      times.cluster.codes.push_back(study.day[i]);
    }
  }
  times.cluster.levels.resize(many.days);
  times.predictors =
      Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  times.log_time = Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()));
  const auto fit = log_time_fit(times, {0}, 0.95);
  EXPECT_NEAR(*fit.r2_marginal, coverage::limit_r2(coverage::kFirstCorrelation), 0.02);
  EXPECT_LT(coverage::limit_r2(coverage::kSecondCorrelation),
            coverage::limit_r2(coverage::kFirstCorrelation));
}

TEST(HypothesesStudy, ADataSetHasEveryNumberAndALineReadsBack) {
  coverage::Scenario scenario;
  scenario.days = 40;
  coverage::Options options;
  options.replicates = 30;
  const coverage::Misses set = coverage::misses_of(scenario, 700, options, 3);
  std::size_t there = 0;
  for (const auto& one : set.of) {
    there += one ? 1 : 0;
  }
  EXPECT_EQ(there, coverage::kPrinted.size());
  const auto back = table::from_row<coverage::Misses>(table::row_text(set));
  EXPECT_EQ(back.of, set.of);
  const auto rates = coverage::miss_rates(scenario, {set, set});
  EXPECT_EQ(rates.front().sets, 2U);
}

TEST(AdvanceStudy, FewDaysAreWithheldAndManyAreNot) {
  coverage::Options options;
  options.replicates = 60;
  coverage::AdvanceScenario few;
  few.days = 6;
  for (const auto& one : coverage::advance_misses_of(few, 800, options, 0).of) {
    EXPECT_FALSE(one);
  }
  coverage::AdvanceScenario many;
  many.days = 400;
  const coverage::AdvanceMisses set = coverage::advance_misses_of(many, 800, options, 1);
  std::size_t missed = 0;
  for (std::size_t k = 0; k < 7; ++k) {
    ASSERT_TRUE(set.of[k]) << coverage::kAdvancePrinted[k].name;
    missed += *set.of[k] ? 1 : 0;
  }
  EXPECT_LE(missed, 2U) << "intervals of 400 days hold the truth nearly always";
}

}  // namespace
}  // namespace tcert::study
