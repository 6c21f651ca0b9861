#include "analysis/study/verdict.hpp"

#include <gtest/gtest.h>

namespace tcert::study {
namespace {

H1Row rival(double gain, std::optional<statistics::Interval> interval) {
  H1Row row;
  row.kind = H1RowKind::rival;
  row.auc_gain.value = gain;
  row.auc_gain.interval = interval;
  return row;
}

const H1Score& auc_gain(const H1Row& row) { return row.auc_gain; }

TEST(Verdict, OfH1NeedsEveryRivalToBeBeaten) {
  H1Panel panel;
  panel.rows.emplace_back();  // The one under test, which has no gain.
  panel.rows.front().kind = H1RowKind::predictor;
  panel.rows.push_back(rival(0.2, statistics::Interval{0.1, 0.3}));
  panel.rows.push_back(rival(0.3, statistics::Interval{0.01, 0.6}));
  const H1Verdict supported = h1_verdict(panel, auc_gain);
  EXPECT_EQ(supported.verdict, Verdict::supported);
  EXPECT_EQ(supported.rival, &panel.rows[2]) << "its interval reaches lowest";

  panel.rows[2] = rival(0.3, statistics::Interval{0.0, 0.6});
  EXPECT_EQ(h1_verdict(panel, auc_gain).verdict, Verdict::not_decided) << "0 itself is not above 0";
  panel.rows[2] = rival(0.3, {});
  EXPECT_EQ(h1_verdict(panel, auc_gain).verdict, Verdict::not_decided)
      << "withheld decides nothing";
  panel.rows[2] = rival(-0.2, statistics::Interval{-0.3, -0.1});
  const H1Verdict contradicted = h1_verdict(panel, auc_gain);
  EXPECT_EQ(contradicted.verdict, Verdict::contradicted);
  EXPECT_EQ(contradicted.rival, &panel.rows[2]);
}

TEST(Verdict, OfH1CitesTheGainThatDecides) {
  H1Panel panel;
  panel.rows.push_back(rival(0.08, statistics::Interval{-0.13, 0.33}));
  panel.rows.push_back(rival(-0.03, statistics::Interval{-0.06, -0.01}));
  const H1Verdict found = h1_verdict(panel, auc_gain);
  EXPECT_EQ(found.verdict, Verdict::contradicted);
  EXPECT_EQ(found.rival, &panel.rows[1]) << "the noisy one reaches lower and decides nothing";
  EXPECT_LT(found.gain->interval->high, 0.0);
}

TEST(Verdict, OfH1LooksAtSingleRivalsAlone) {
  H1Panel panel;
  EXPECT_EQ(h1_verdict(panel, auc_gain).verdict, Verdict::not_decided) << "no rival, no support";
  EXPECT_EQ(h1_verdict(panel, auc_gain).gain, nullptr);
  panel.rows.push_back(rival(0.2, statistics::Interval{0.1, 0.3}));
  panel.rows.push_back(rival(-0.2, statistics::Interval{-0.3, -0.1}));
  panel.rows.back().kind = H1RowKind::together;
  EXPECT_EQ(h1_verdict(panel, auc_gain).verdict, Verdict::supported);
}

H2Equality equality_of(double low, double high, double margin, std::optional<bool> equivalent) {
  H2Equality equality;
  equality.tests.options.margin = margin;
  equality.tests.equivalent = equivalent;
  equality.tests.pairs.emplace_back();
  equality.tests.pairs.front().second = 1;
  equality.tests.pairs.front().standard_error = 0.25 * (high - low);
  equality.tests.pairs.front().interval = {low, high};
  return equality;
}

TEST(Verdict, OfH2IsContradictedOnlyByAPairBeyondTheMargin) {
  H2Panel panel;
  panel.levels.resize(2);
  EXPECT_EQ(h2_verdict(panel, equality_of(-0.04, 0.04, 0.05, true)), Verdict::supported);
  EXPECT_EQ(h2_verdict(panel, equality_of(0.01, 0.2, 0.05, false)), Verdict::not_decided)
      << "different, but perhaps by less than the margin";
  EXPECT_EQ(h2_verdict(panel, equality_of(0.06, 0.2, 0.05, false)), Verdict::contradicted);
  EXPECT_EQ(h2_verdict(panel, equality_of(-0.2, -0.06, 0.05, false)), Verdict::contradicted);
  panel.levels[1].withheld = "3 clusters, fewer than 5";
  EXPECT_EQ(h2_verdict(panel, equality_of(0.06, 0.2, 0.05, {})), Verdict::not_decided);
}

TEST(Verdict, OfH2IsOfPairsWithIntervals) {
  H2Panel panel;
  panel.levels.resize(3);
  H2Equality equality = equality_of(0.16, 0.19, 0.05, false);
  statistics::EquivalencePair withheld = equality.tests.pairs.front();
  withheld.first = 0;
  withheld.second = 2;
  withheld.interval = {0.9, 1.0};
  equality.tests.pairs.push_back(withheld);
  panel.levels[2].withheld = "6 failures, fewer than 10";
  EXPECT_EQ(h2_verdict(panel, equality), Verdict::contradicted);
  EXPECT_EQ(deciding_pair(panel, equality), &equality.tests.pairs.front());

  H2Equality certain = equality_of(0.0, 0.0, 0.05, true);
  EXPECT_EQ(h2_verdict(panel, certain), Verdict::not_decided)
      << "without a variance nothing is equal";
}

TEST(Verdict, OfH3NeedsAGainAndFewLosses) {
  H3Chosen one;
  EXPECT_EQ(h3_verdict(one, 0.05), Verdict::not_decided);
  one.gain.interval = statistics::Interval{0.1, 0.3};
  one.lost_lower = 0.0;
  one.lost_upper = 0.04;
  EXPECT_EQ(h3_verdict(one, 0.05), Verdict::supported);
  one.lost_upper = 0.07;
  EXPECT_EQ(h3_verdict(one, 0.05), Verdict::not_decided);
  one.lost_lower = 0.06;
  EXPECT_EQ(h3_verdict(one, 0.05), Verdict::contradicted) << "the loss is above the margin";
  one.lost_lower = 0.0;
  one.lost_upper = 0.04;
  one.gain.interval = statistics::Interval{-0.3, -0.1};
  EXPECT_EQ(h3_verdict(one, 0.05), Verdict::contradicted) << "slower";
}

}  // namespace
}  // namespace tcert::study
