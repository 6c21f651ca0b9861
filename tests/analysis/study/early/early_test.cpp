// What the figures of the early certificate show: by hand, and what must hold of any study.
#include <table/read_data_table.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <statistics/basics/binomial_interval.hpp>
#include <stdexcept>
#include <table/bytes.hpp>
#include <table/random.hpp>

#include "analysis/study/early/auc_by_day.hpp"
#include "analysis/study/early/early_histogram.hpp"
#include "analysis/study/early/operating_point.hpp"
#include "analysis/study/early/success_by_quantile.hpp"

namespace tcert::study {
namespace {

EarlyTrials trials_of(std::vector<double> values,
                      std::vector<std::uint8_t> success,
                      std::vector<std::uint32_t> days = {}) {
  EarlyTrials trials;
  trials.tc_early_m = std::move(values);
  trials.success = std::move(success);
  trials.has_days = !days.empty();
  if (days.empty()) {
    days.resize(trials.size());
    std::iota(days.begin(), days.end(), 0U);
  }
  for (const std::uint32_t day : days) {
    while (trials.day.levels.size() <= day) {
      trials.day.levels.push_back("D" + std::to_string(trials.day.levels.size()));
    }
  }
  trials.day.codes = std::move(days);
  return trials;
}

/// Values in steps of 0.01 m, so that they tie; more success with more room; 20 days.
EarlyTrials random_trials(std::uint64_t seed, std::size_t count) {
  table::RandomStream random(seed, 1, 0);
  std::vector<double> values;
  std::vector<std::uint8_t> success;
  std::vector<std::uint32_t> days;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t step = random.below(20);
    values.push_back(0.01 * step - 0.02);
    success.push_back(random.below(24) < step + 4 ? 1 : 0);
    days.push_back(static_cast<std::uint32_t>(i % 20));
  }
  return trials_of(values, success, days);
}

TEST(EarlyTrials, AreThoseOfTheLandmarkPanelWhereThereIsOne) {
  table::CsvOptions csv;
  csv.file = "features.csv";
  const table::DataTable features =
      *table::read_data_table(
           table::Bytes::copy_of("trial_id,day,success,time_s,tc_early,tc_landmark,end_s\n"
                                 "a,D1,1,60,0.1,0.2,61\n"
                                 "b,D1,0,10,0.3,0.4,11\n"  // Over before the landmark.
                                 "c,D2,0,50,0.5,,51\n"     // No early certificate.
                                 "d,D2,,50,0.6,0.7,51\n"   // No outcome.
                                 "e,D2,0,70,0.8,0.9,71\n"),
           {},
           csv)
           .table;
  const EarlyTrials trials = *early_trials(features);
  EXPECT_EQ(trials.kind, H1PanelKind::landmark);
  EXPECT_EQ(trials.tc_early_m, (std::vector<double>{0.2, 0.9}));
  EXPECT_EQ(trials.success, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_TRUE(trials.has_days);
  EXPECT_EQ(early_trials(features, 5.0)->size(), 3U) << "all of them run at 5 s";
  EXPECT_FALSE(early_trials(table::DataTable{}).has_value());
}

TEST(SuccessByQuantile, CutsTrialsIntoEqualPartsAndKeepsTiesTogether) {
  std::vector<double> values(50);
  std::iota(values.begin(), values.end(), 1.0);
  std::vector<std::uint8_t> success(50, 1);
  success[0] = success[1] = 0;
  const auto groups = success_by_quantile(trials_of(values, success), 5);
  ASSERT_EQ(groups.size(), 5U);
  for (const QuantileGroup& group : groups) {
    EXPECT_EQ(group.trials, 10U);
  }
  EXPECT_EQ(groups[0].successes, 8U);
  EXPECT_EQ(groups[0].low_m, 1.0);
  EXPECT_EQ(groups[0].high_m, 10.0);
  EXPECT_EQ(success_by_quantile(trials_of({1, 1, 1, 1}, {1, 0, 1, 1}), 5).size(), 1U);
  EXPECT_EQ(quantile_groups(199), 5U);
  EXPECT_EQ(quantile_groups(200), 10U);
  EXPECT_THROW((void)success_by_quantile(trials_of({1}, {1}), 0), std::invalid_argument);
}

TEST(SuccessByQuantile, CountsEveryTrialOnceInOrder) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const EarlyTrials trials = random_trials(seed, 230);
    std::size_t counted = 0;
    double before = -1.0;
    for (const QuantileGroup& group : success_by_quantile(trials, 10)) {
      counted += group.trials;
      EXPECT_GT(group.low_m, before) << "a value in two groups";
      EXPECT_LE(group.low_m, group.high_m);
      before = group.high_m;
      EXPECT_LE(group.successes, group.trials);
      EXPECT_LE(group.interval.low, group.share);
      EXPECT_GE(group.interval.high, group.share);
      EXPECT_GE(group.interval.low, 0.0);
      EXPECT_LE(group.interval.high, 1.0);
    }
    EXPECT_EQ(counted, trials.size());
  }
}

TEST(EarlyHistogram, HasEveryTrialInTheBinOfItsValue) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const EarlyTrials trials = random_trials(seed, 200);
    const auto bins = early_histogram(trials);
    EXPECT_LE(bins.size(), 31U);
    std::size_t counted = 0;
    for (std::size_t b = 0; b < bins.size(); ++b) {
      std::size_t inside = 0;
      for (const double value : trials.tc_early_m) {
        inside += value >= bins[b].low_m && value < bins[b].high_m ? 1 : 0;
      }
      EXPECT_EQ(bins[b].successes + bins[b].failures, inside) << bins[b].low_m;
      counted += inside;
      if (b > 0) {
        EXPECT_EQ(bins[b].low_m, bins[b - 1].high_m);
      }
    }
    EXPECT_EQ(counted, trials.size());
  }
  EXPECT_EQ(early_histogram(trials_of({0.05, 0.05}, {1, 0})).size(), 1U);
  // Beyond 2^53 there are no neighbours to count, and still it ends.
  EXPECT_LE(early_histogram(trials_of({1e16, 1e16, -1e16}, {1, 0, 1})).size(), 31U);
}

TEST(AucByDay, IsThatOfEachDayAndOfAll) {
  // Day 0: both pairs in order. Day 1: one of two. Day 2: no failure.
  const AucByDay found = auc_by_day(
      trials_of({0.3, 0.2, 0.1, 0.3, 0.1, 0.2, 0.5}, {1, 1, 0, 1, 1, 0, 1}, {0, 0, 0, 1, 1, 1, 2}));
  ASSERT_EQ(found.days.size(), 3U);
  EXPECT_EQ(found.days[0].day, "D0");
  EXPECT_EQ(found.days[0].auc, 1.0);
  EXPECT_EQ(found.days[1].auc, 0.5);
  EXPECT_FALSE(found.days[2].auc.has_value());
  EXPECT_FALSE(found.days[2].interval.has_value());
  EXPECT_TRUE(found.days[0].is_few());
  EXPECT_EQ(found.within, 0.75) << "two pairs each";
  // Five successes, two failures: 10 pairs, one wrong and two tied.
  EXPECT_DOUBLE_EQ(*found.pooled.auc, 0.8);
  EXPECT_FALSE(found.pooled.interval.has_value()) << "three days are too few";
  EXPECT_FALSE(found.within_interval.has_value());
}

TEST(AucByDay, HasIntervalsOfWholeDaysWhereThereAreEnough) {
  const AucByDay found = auc_by_day(random_trials(3, 400));
  ASSERT_TRUE(found.pooled.interval.has_value());
  ASSERT_TRUE(found.within_interval.has_value());
  EXPECT_LT(found.within_interval->low, *found.within);
  EXPECT_GT(found.within_interval->high, *found.within);
  EXPECT_GT(*found.pooled.auc, 0.6);
}

TEST(ScoreAucInterval, EndsWhereTheObservedAucIsJustPossible) {
  for (const auto& [auc, m, n] : {std::tuple(0.8, 27U, 3U), {0.5, 10U, 10U}, {0.95, 200U, 40U}}) {
    const statistics::Interval interval = score_auc_interval(auc, m, n);
    for (const double end : {interval.low, interval.high}) {
      // Hanley and McNeil's variance with both sizes their mean in the second factor.
      const double others = (m + n) / 2.0 - 1.0;
      const double variance =
          end * (1.0 - end) *
          (1.0 + others * (1.0 - end) / (2.0 - end) + others * end / (1.0 + end)) / (m * n);
      EXPECT_NEAR(std::abs(end - auc), 1.959963984540054 * std::sqrt(variance), 1e-9);
    }
    EXPECT_LT(interval.low, auc);
    EXPECT_GT(interval.high, auc);
  }
  const statistics::Interval separated = score_auc_interval(1.0, 27, 3);
  EXPECT_EQ(separated.high, 1.0);
  EXPECT_LT(separated.low, 0.8) << "three failures do not prove a perfect score";
  EXPECT_GT(separated.low, 0.4);
  EXPECT_NEAR(score_auc_interval(0.2, 8, 5).low, 1.0 - score_auc_interval(0.8, 8, 5).high, 1e-12);
  EXPECT_THROW((void)score_auc_interval(0.5, 0, 3), std::invalid_argument);
  EXPECT_THROW((void)score_auc_interval(std::nan(""), 3, 3), std::invalid_argument);
}

TEST(OperatingPoint, KeepsTheShareOfSuccessesThatWasAskedFor) {
  // 20 successes at 1 to 20: one may be lost, so that the threshold is the second.
  std::vector<double> values(20);
  std::iota(values.begin(), values.end(), 1.0);
  std::vector<std::uint8_t> success(20, 1);
  for (const double failure : {0.5, 1.5, 2.0, 9.0}) {
    values.push_back(failure);
    success.push_back(0);
  }
  const OperatingPoint point = *operating_point(trials_of(values, success), 0.95);
  EXPECT_EQ(point.threshold_m, 2.0);
  EXPECT_DOUBLE_EQ(point.kept.value, 0.95);
  EXPECT_DOUBLE_EQ(point.stopped.value, 0.5) << "a failure at the threshold goes on";
  EXPECT_FALSE(point.by_days);
  EXPECT_FALSE(point.threshold_interval.has_value());
  EXPECT_EQ(point.stopped.interval->low, statistics::wilson(2, 4)->low);
  EXPECT_EQ(point.kept.interval->high, statistics::wilson(19, 20)->high);
  EXPECT_EQ(operating_point(trials_of(values, success), 1.0)->threshold_m, 1.0);
  EXPECT_FALSE(operating_point(trials_of({1, 2}, {1, 1})).has_value());
  EXPECT_THROW((void)operating_point(trials_of(values, success), 0.0), std::invalid_argument);
}

TEST(OperatingPoint, IsTheLargestThresholdThatDoes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const EarlyTrials trials = random_trials(seed, 300);
    const OperatingPoint point = *operating_point(trials);
    const auto kept_at = [&](double threshold) {
      const std::vector<double> values = trials.sorted_values(true);
      const auto above = std::count_if(
          values.begin(), values.end(), [&](double value) { return value >= threshold; });
      return static_cast<double>(above) / static_cast<double>(values.size());
    };
    EXPECT_GE(kept_at(point.threshold_m), 0.95 - 1e-12);
    EXPECT_LT(kept_at(std::nextafter(point.threshold_m, 1.0)), 0.95);
    EXPECT_DOUBLE_EQ(point.kept.value, kept_at(point.threshold_m));
    EXPECT_TRUE(point.by_days);
    for (const OperatingShare& share : {point.kept, point.stopped}) {
      EXPECT_LE(share.interval->low, share.value);
      EXPECT_GE(share.interval->high, share.value);
    }
    EXPECT_LE(point.threshold_interval->low, point.threshold_m);
    EXPECT_GE(point.threshold_interval->high, point.threshold_m);
  }
}

TEST(OperatingCurve, KeepsLessAndStopsMoreWithALargerThreshold) {
  const auto curve = operating_curve(random_trials(1, 300), 50);
  ASSERT_EQ(curve.size(), 50U);
  EXPECT_EQ(curve.front().kept, 1.0);
  EXPECT_EQ(curve.front().stopped, 0.0);
  for (std::size_t p = 1; p < curve.size(); ++p) {
    EXPECT_GT(curve[p].threshold_m, curve[p - 1].threshold_m);
    EXPECT_LE(curve[p].kept, curve[p - 1].kept);
    EXPECT_GE(curve[p].stopped, curve[p - 1].stopped);
  }
}

}  // namespace
}  // namespace tcert::study
