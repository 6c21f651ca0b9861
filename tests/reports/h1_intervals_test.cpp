#include "reports/h1_intervals.hpp"

#include <gtest/gtest.h>

#include "reports/table.hpp"

namespace tcert {
namespace {

TEST(IntervalTable, SaysWhyACellOfBcaIsMissing) {
  study::H1Score score;
  score.value = 0.7;
  score.intervals.expanded = statistics::Interval{0.6, 0.8, 0.95};
  score.intervals.percentile = statistics::Interval{0.61, 0.79, 0.95};
  score.intervals.no_bca = statistics::Condition{statistics::ConditionKind::infinite_bias,
                                                 statistics::ConditionSeverity::warning,
                                                 "",
                                                 "no replicate below"};
  Table table = score_interval_table(
      "h1_intervals", "predictor", "predictor", {{{score}, "paper", "tc_early", "AUC"}});
  ASSERT_EQ(table.rows.size(), 1U);
  ASSERT_EQ(table.footnotes.size(), 1U);
  EXPECT_EQ(table.footnotes[0],
            "paper, tc_early, AUC, no BCa interval: " + to_string(*score.intervals.no_bca) + ".");
  score.intervals.no_bca.reset();
  table = score_interval_table(
      "h1_intervals", "predictor", "predictor", {{{score}, "paper", "dwell", "AUC"}});
  EXPECT_TRUE(table.footnotes.empty());
}

}  // namespace
}  // namespace tcert
