// Figures of the early certificate: ranges, units, what must rise, and what is missing.
#include "reports/figure/early_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "reports/figure/figure_table.hpp"
#include "reports/figure/gnuplot.hpp"
#include "reports/figure/h1_figures.hpp"
#include "reports/figure/vega_lite.hpp"

namespace tcert {
namespace {

/// 240 trials of 12 days; more room, more success. Day 3 has no failure.
study::EarlyTrials some_trials() {
  study::EarlyTrials trials;
  trials.kind = study::H1PanelKind::landmark;
  trials.has_days = true;
  trials.landmark_s = 15.0;
  for (std::uint32_t i = 0; i < 240; ++i) {
    const std::uint32_t step = (i * 7U) % 60U;
    const std::uint32_t day = i % 12U;
    trials.tc_early_m.push_back(0.002 * step);
    trials.success.push_back(day == 3 || step > 20 || i % 5U == 0 ? 1 : 0);
    trials.day.codes.push_back(day);
  }
  for (int day = 0; day < 12; ++day) {
    trials.day.levels.push_back("D" + std::to_string(day));
  }
  return trials;
}

std::vector<double> column_of(const Figure& figure, const char* part, const char* column) {
  std::vector<double> values;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    if (text_at(figure.data, row, "part") == part) {
      values.push_back(number_at(figure.data, row, column));
    }
  }
  return values;
}

void expect_shares(const std::vector<double>& values) {
  for (const double value : values) {
    EXPECT_TRUE(std::isnan(value) || (value >= 0.0 && value <= 1.0)) << value;
  }
}

TEST(EarlyFigures, HaveEveryFormAndMetresOnTheirAxes) {
  const study::EarlyTrials trials = some_trials();
  for (const auto& figure : {success_by_quantile_figure(trials, SyntheticLabel{1}),
                             early_by_outcome_figure(trials, SyntheticLabel{1}),
                             operating_point_figure(trials, SyntheticLabel{1}),
                             auc_by_day_figure(trials, SyntheticLabel{1})}) {
    ASSERT_TRUE(figure.has_value());
    SCOPED_TRACE(figure->name);
    check(*figure);
    EXPECT_FALSE(gnuplot_script(*figure).empty());
    EXPECT_NE(vega_lite(*figure).dump().find("SYNTHETIC"), std::string::npos);
    EXPECT_NE(figure->caption.find("first 15 s, 240 trials"), std::string::npos) << figure->caption;
    EXPECT_NE(figure->caption.find("95 %") == std::string::npos,
              figure->name != "early_by_outcome");
    EXPECT_EQ(figure->panels[0].x.unit, figure->name == "auc_by_day" ? "" : "m");
  }
}

TEST(SuccessByQuantileFigure, RisesWithTheCertificateAndAddsUp) {
  const Figure figure = *success_by_quantile_figure(some_trials(), std::nullopt);
  const std::vector<double> share = column_of(figure, "group", "share");
  const std::vector<double> trials = column_of(figure, "group", "trials");
  expect_shares(share);
  expect_shares(column_of(figure, "group", "share_low"));
  expect_shares(column_of(figure, "group", "share_high"));
  EXPECT_LT(share.front(), share.back());
  double sum = 0.0;
  for (const double count : trials) {
    sum += count;
  }
  EXPECT_EQ(sum, 240.0);
}

TEST(EarlyByOutcomeFigure, HasAHundredPercentOfEachOutcome) {
  const Figure figure = *early_by_outcome_figure(some_trials(), std::nullopt);
  for (const char* const outcome : {"success", "failure"}) {
    double sum = 0.0;
    for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
      if (text_at(figure.data, row, "part") == "fill" &&
          text_at(figure.data, row, "outcome") == outcome) {
        sum += number_at(figure.data, row, "share") / 2.0;  // Both edges of a bin.
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-12) << outcome;
  }
  const std::vector<double> medians = column_of(figure, "median", "tc_early_m");
  ASSERT_EQ(medians.size(), 2U);
  EXPECT_GT(medians[0], medians[1]) << "successes first";
}

TEST(AucByDayFigure, SaysWhichDaysHaveTooFewOutcomes) {
  const study::EarlyTrials trials = some_trials();
  std::vector<int> failures(12);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    failures[trials.day.codes[i]] += trials.success[i] == 0 ? 1 : 0;
  }
  const auto without = std::count(failures.begin(), failures.end(), 0);
  ASSERT_GE(without, 1);
  const Figure figure = *auc_by_day_figure(trials, std::nullopt);
  EXPECT_EQ(figure.panels[0].y.categories.size(), 14U) << "12 days, and all of them twice";
  expect_shares(column_of(figure, "day", "auc"));
  expect_shares(column_of(figure, "day", "auc_low"));
  expect_shares(column_of(figure, "day", "auc_high"));
  const auto missing = column_of(figure, "no_auc", "failures");
  EXPECT_EQ(missing, std::vector<double>(static_cast<std::size_t>(without), 0.0));
  EXPECT_EQ(column_of(figure, "day", "auc").size(), 14U - missing.size());
  EXPECT_NE(figure.caption.find(std::to_string(without) + " of 12 days have one outcome alone"),
            std::string::npos)
      << figure.caption;
  EXPECT_EQ(figure.panels[0].y.categories.back(),
            "D0: " + std::to_string(failures[0]) + " of 20 failed");
}

TEST(OperatingPointFigure, FallsAndRises) {
  const Figure figure = *operating_point_figure(some_trials(), std::nullopt);
  std::string before;
  double last = 0.0;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    if (text_at(figure.data, row, "part") != "curve") {
      continue;
    }
    const std::string quantity = text_at(figure.data, row, "quantity");
    const double share = number_at(figure.data, row, "share");
    if (quantity == before) {
      EXPECT_TRUE(quantity == "successes kept" ? share <= last : share >= last) << row;
    }
    before = quantity;
    last = share;
  }
  const std::vector<double> points = column_of(figure, "point", "share");
  ASSERT_EQ(points.size(), 2U);
  EXPECT_GE(points[0], 0.95);
  expect_shares(column_of(figure, "curve", "share"));
}

TEST(EarlyFigures, AreLeftOutWithoutWhatTheyNeed) {
  study::EarlyTrials trials = some_trials();
  trials.has_days = false;
  EXPECT_FALSE(auc_by_day_figure(trials, std::nullopt));
  trials.success.assign(trials.size(), 1);
  EXPECT_FALSE(early_by_outcome_figure(trials, std::nullopt));
  EXPECT_FALSE(operating_point_figure(trials, std::nullopt));
  trials.tc_early_m.assign(trials.size(), 0.1);
  EXPECT_FALSE(success_by_quantile_figure(trials, std::nullopt)) << "one value is one group";
  EXPECT_FALSE(within_figure({}, {}, {}, {}));
}

TEST(WithinFigure, PutsBothPairsOfEveryPredictorUnderEachOther) {
  Table pooled;
  pooled.columns = {{"panel", "", "", ColumnKind::text},
                    {"predictor", "", "", ColumnKind::text},
                    {"auc", "AUC [95 % expanded]", "", ColumnKind::estimate}};
  Table within = pooled;
  within.columns[2] = {"auc_within", "AUC within [95 % expanded]", "", ColumnKind::estimate};
  for (const char* const panel : {"paper", "landmark"}) {
    pooled.add_row({std::string(panel), std::string("tc_landmark"), Estimate{0.8, 0.7, 0.9}});
    pooled.add_row({std::string(panel), std::string("rivals together"), Estimate{0.6, 0.5, 0.7}});
    within.add_row({std::string(panel), std::string("tc_landmark"), Estimate{0.7, 0.6, 0.8}});
  }
  const Figure figure = *within_figure(pooled, within, {}, {});
  ASSERT_EQ(figure.panels.size(), 1U) << "no times, no panel of C";
  EXPECT_EQ(figure.panels[0].y.categories,
            (std::vector<std::string>{"TC_early (within)", "TC_early (all)"}));
  EXPECT_EQ(column_of(figure, "score", "score"), (std::vector<double>{0.8, 0.7}));
  EXPECT_NE(figure.caption.find("95 % expanded intervals"), std::string::npos);
}

}  // namespace
}  // namespace tcert
