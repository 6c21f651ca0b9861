#include "analysis/hypotheses_h1.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "datasets/random.hpp"

namespace tcert {
namespace {

/// A trial of 60 s whose four predictors, in both panels, are the given ones.
FeatureRow trial(bool success, double tc, double contacts, double dwell, double variance) {
  FeatureRow row;
  row.trial.success = success;
  row.trial.time_s = 60.0;
  Features& features = row.features;
  features.tc_early = features.tc_landmark = tc;
  features.contacts_per_m = features.contacts_per_m_landmark = contacts;
  features.dwell = features.dwell_landmark = dwell;
  features.bend_variance = features.bend_variance_landmark = variance;
  features.end_s = 61.0;
  features.window_end_s = 30.0;
  features.still_at_landmark = false;
  features.issued = success;
  return row;
}

std::vector<FeatureRow> six_trials() {
  return {trial(true, 0.30, 1, 0.1, 0.5),
          trial(true, 0.20, 2, 0.2, 0.5),
          trial(true, 0.10, 3, 0.3, 0.5),
          trial(true, 0.25, 4, 0.1, 0.5),
          trial(false, 0.15, 1, 0.4, 0.5),
          trial(false, -0.05, 5, 0.5, 0.5)};
}

TEST(HypothesisH1, ScoresEachPredictorInItsDirection) {
  const H1Table table = hypothesis_h1(six_trials());
  ASSERT_EQ(table.panels.size(), 2U);
  for (const H1Panel& panel : table.panels) {
    SCOPED_TRACE(to_string(panel.kind));
    ASSERT_EQ(panel.rows.size(), 4U);
    EXPECT_EQ(panel.trials, 6U);
    EXPECT_EQ(panel.complete, 6U);
    // TC: of 8 pairs only 0.10 < 0.15 is lost. Contacts: failures 1 and 5 against 1, 2, 3, 4:
    // half a pair and all four. Dwell separates; the variance is constant.
    EXPECT_EQ(panel.rows[0].auc.auc, 7.0 / 8.0);
    EXPECT_EQ(panel.rows[1].auc.auc, 4.5 / 8.0);
    EXPECT_EQ(panel.rows[2].auc.auc, 1.0);
    EXPECT_EQ(panel.rows[3].auc.auc, 0.5);
    ASSERT_EQ(panel.rows[3].auc.conditions.size(), 1U);
    EXPECT_TRUE(has(panel.rows[3].auc.conditions, ConditionKind::all_tied));
    EXPECT_FALSE(panel.rows[0].tc_gain.has_value());
    EXPECT_EQ(panel.rows[1].tc_gain->difference, 2.5 / 8.0);
    EXPECT_EQ(panel.rows[2].tc_gain->difference, -1.0 / 8.0);
    EXPECT_EQ(panel.rows[0].auc.successes, 4U);
    EXPECT_EQ(panel.rows[0].auc.failures, 2U);
  }
  EXPECT_EQ(table.panels[0].rows[0].predictor, "tc_early");
  EXPECT_EQ(table.panels[1].rows[0].predictor, "tc_landmark");
}

TEST(HypothesisH1, UsesTheCommonCompleteCasesInEveryRow) {
  std::vector<FeatureRow> trials = six_trials();
  trials[0].features.dwell.reset();
  trials[1].features.tc_early.reset();
  trials[1].features.dwell.reset();
  const H1Table table = hypothesis_h1(trials);
  const H1Panel& paper = table.panels[0];
  EXPECT_EQ(paper.trials, 6U);
  EXPECT_EQ(paper.complete, 4U);
  EXPECT_EQ(paper.rows[0].missing, 1U);
  EXPECT_EQ(paper.rows[1].missing, 0U);
  EXPECT_EQ(paper.rows[2].missing, 2U);
  for (const H1Row& row : paper.rows) {
    EXPECT_EQ(row.auc.successes, 2U);
    EXPECT_EQ(row.auc.failures, 2U);
  }
  EXPECT_EQ(table.panels[1].complete, 6U) << "the other panel has its own features";
}

TEST(HypothesisH1, ExcludesFromTheLandmarkPanelWhatIsDecidedByThen) {
  std::vector<FeatureRow> trials = six_trials();
  trials[0].trial.time_s = 15.0;
  trials[4].features.still_at_landmark = true;
  trials[5].trial.time_s.reset();
  trials[5].features.end_s = 14.0;
  trials[5].features.still_at_landmark = true;
  const H1Table table = hypothesis_h1(trials);
  const H1Panel& landmark = table.panels[1];
  EXPECT_EQ(landmark.ended_by_landmark, 2U);
  EXPECT_EQ(landmark.still_at_landmark, 1U);
  EXPECT_EQ(landmark.trials, 3U);
  ASSERT_EQ(landmark.rows[0].auc.conditions.size(), 1U);
  EXPECT_TRUE(has(landmark.rows[0].auc.conditions, ConditionKind::one_class));
  EXPECT_EQ(landmark.rows[0].auc.conditions[0].detail, "no failures");
  EXPECT_EQ(table.panels[0].trials, 6U);
}

TEST(HypothesisH1, CountsTrialsThatEndInsideTheirWindow) {
  std::vector<FeatureRow> trials = six_trials();
  trials[0].trial.time_s = 29.0;            // at the goal before the window closed
  trials[4].features.window_end_s.reset();  // the log ends inside
  trials[5].features.window_end_s.reset();  // nothing known of its log
  trials[5].features.end_s.reset();
  const H1Panel paper = hypothesis_h1(trials).panels[0];
  EXPECT_EQ(paper.ended_in_window, 2U);
  EXPECT_EQ(paper.failures_ended_in_window, 1U);
}

TEST(HypothesisH1, LeavesOutTrialsWithoutAnOutcome) {
  std::vector<FeatureRow> trials = six_trials();
  trials[2].trial.success.reset();
  const H1Table table = hypothesis_h1(trials);
  EXPECT_EQ(table.trials, 6U);
  EXPECT_EQ(table.outcome_missing, 1U);
  EXPECT_EQ(table.panels[0].trials, 5U);
  EXPECT_EQ(table.issued[0].trials, 3U);
  EXPECT_EQ(table.issued[0].issued, 3U);
  EXPECT_EQ(table.issued[1].trials, 2U);
  EXPECT_EQ(table.issued[1].issued, 0U);
}

TEST(HypothesisH1, DescribesTheCertificatePerOutcome) {
  std::vector<FeatureRow> trials = six_trials();
  trials.push_back(trial(true, 0.0, 0, 0, 0));
  trials.back().features.tc_early.reset();
  const H1Panel paper = hypothesis_h1(trials).panels[0];
  ASSERT_EQ(paper.distribution.size(), 2U);
  const TcDistribution& successes = paper.distribution[0];
  EXPECT_TRUE(successes.success);
  EXPECT_EQ(successes.trials, 5U);
  EXPECT_EQ(successes.missing, 1U);
  EXPECT_EQ(successes.negative, 0U);
  EXPECT_DOUBLE_EQ(successes.p50.value(), 0.225);
  const TcDistribution& failures = paper.distribution[1];
  EXPECT_EQ(failures.negative, 1U);
  EXPECT_DOUBLE_EQ(failures.p10.value(), -0.05 + 0.1 * 0.20);
}

TEST(HypothesisH1, NamesAnEmptyTable) {
  const H1Table table = hypothesis_h1({});
  ASSERT_EQ(table.panels.size(), 2U);
  for (const H1Row& row : table.panels[0].rows) {
    EXPECT_EQ(row.auc.auc, std::nullopt);
    ASSERT_EQ(row.auc.conditions.size(), 1U);
    EXPECT_TRUE(has(row.auc.conditions, ConditionKind::no_rows));
  }
  EXPECT_EQ(table.panels[0].distribution[0].p50, std::nullopt);
}

TEST(HypothesisH1, DoesNotDependOnTheOrderOfTrials) {
  RandomStream random(5, 0, 0);
  std::vector<FeatureRow> trials;
  for (int i = 0; i < 120; ++i) {
    trials.push_back(trial(i % 5 != 0,
                           static_cast<double>(random.below(20)),
                           static_cast<double>(random.below(9)),
                           random.uniform(),
                           random.uniform()));
  }
  const H1Panel before = hypothesis_h1(trials).panels[0];
  std::reverse(trials.begin(), trials.end());
  const H1Panel after = hypothesis_h1(trials).panels[0];
  for (std::size_t k = 0; k < before.rows.size(); ++k) {
    EXPECT_EQ(before.rows[k].auc.auc, after.rows[k].auc.auc);
    EXPECT_NEAR(*before.rows[k].auc.variance, *after.rows[k].auc.variance, 1e-15);
  }
}

TEST(HypothesisH1, FindsNothingInUnrelatedPredictorsAtTheNominalRate) {
  // 500 studies of 660 trials whose outcome depends on nothing: the share of 95 % intervals that
  // cover 0.5, and of paired tests with p < 0.05, per row. Monte-Carlo SD 0.01.
  constexpr int kStudies = 500;
  std::vector<int> covered(4, 0);
  std::vector<int> rejected(4, 0);
  for (int study = 0; study < kStudies; ++study) {
    RandomStream random(17, 0, static_cast<std::uint64_t>(study));
    std::vector<FeatureRow> trials;
    for (int i = 0; i < 660; ++i) {
      const double tc = random.normal();
      const double contacts = static_cast<double>(random.below(12));
      const double dwell = random.below(2) == 0 ? 0.0 : random.uniform();
      const double variance = random.uniform() - 0.3 * tc;
      trials.push_back(trial(i >= 77, tc, contacts, dwell, variance));
    }
    const H1Panel panel = hypothesis_h1(trials).panels[1];
    for (std::size_t k = 0; k < 4; ++k) {
      const Interval interval = panel.rows[k].auc.interval.value();
      covered[k] += interval.low <= 0.5 && 0.5 <= interval.high ? 1 : 0;
      rejected[k] += k > 0 && *panel.rows[k].tc_gain->p_value < 0.05 ? 1 : 0;
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    std::printf("row %zu: interval covers 0.5 in %d of %d studies, paired p < 0.05 in %d\n",
                k,
                covered[k],
                kStudies,
                rejected[k]);
    EXPECT_NEAR(covered[k], 475, 3 * 5);
    if (k > 0) {
      EXPECT_NEAR(rejected[k], 25, 3 * 5);
    }
  }
}

}  // namespace
}  // namespace tcert
