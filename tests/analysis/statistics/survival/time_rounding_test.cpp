#include <statistics/survival/time_rounding.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <statistics/survival/survival_curve.hpp>
#include <statistics/survival/time_conditions.hpp>
#include <string>
#include <table/random.hpp>
#include <table/unlike_times.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

SurvivalOutcome events_at(std::vector<double> stop) {
  SurvivalOutcome outcome;
  outcome.event.assign(stop.size(), 1);
  outcome.stop = std::move(stop);
  return outcome;
}

std::size_t distinct(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return static_cast<std::size_t>(std::unique(times.begin(), times.end()) - times.begin());
}

TEST(TimeRounding, SumsAndDifferencesThatDifferInTheirLastDigitsAreOneTime) {
  SurvivalOutcome outcome = events_at({0.1 + 0.2, 0.3, 16.1 - 15.8, 0.4});
  round_times(outcome);
  EXPECT_EQ(distinct(outcome.stop), 2U);
  EXPECT_EQ(outcome.stop[0], *std::min_element(outcome.stop.begin(), outcome.stop.end()));
}

TEST(TimeRounding, DifferencesOfStampsAreAsExactAsStamps) {
  // 100 s after eight starts in tenths of a second since 1970: off by up to 2.4e-7 s each.
  std::vector<double> times;
  for (int k = 0; k < 8; ++k) {
    const double start = 1764174000.0 + 0.1 * k;
    times.push_back((start + 100.0) - start);
    times.push_back((1764174000.1 + 100.0 + k) - (1764174000.1 + k));
    times.push_back((1764174000.7 + 100.3) - (1764174000.0 + 1.0));
  }
  SurvivalOutcome outcome = events_at(times);
  round_times(outcome);
  EXPECT_EQ(distinct(outcome.stop), 1U);
}

TEST(TimeRounding, StampsInWholeSecondsStayApart) {
  std::vector<double> times;
  for (int k = 0; k < 40; ++k) {
    times.push_back(1700000000.0 + 3.0 * k);
  }
  SurvivalOutcome outcome = events_at(times);
  const TimeRounding rounding = round_times(outcome);
  EXPECT_EQ(outcome.stop, times);
  EXPECT_EQ(rounding.kept, 40U);
  // What aeqSurv makes of it: sqrt(epsilon) of 1.7e9 are 25 s.
  EXPECT_EQ(rounding.by_timefix, 1U);
  EXPECT_NEAR(rounding.timefix_step, 25.3, 0.1);
  Conditions conditions;
  add_rounding_conditions(rounding, "stamp", conditions);
  ASSERT_EQ(conditions.size(), 1U);
  EXPECT_EQ(
      to_string(conditions[0]),
      "note: column 'stamp': distinct times that R's timefix would make equal are kept apart: "
      "40 distinct times, of which those within 25.3 of a neighbour would leave 1; subtract "
      "the first time, and both agree");
}

TEST(TimeRounding, OneStampAmongSecondsTiesNothing) {
  SurvivalOutcome outcome = events_at({5, 9, 13, 17, 1764174008});
  round_times(outcome);
  EXPECT_EQ(distinct(outcome.stop), 5U);
  Conditions conditions;
  add_unlike_times(
      outcome.stop,
      "time_s",
      [](std::size_t i) { return "row " + std::to_string(i + 1); },
      conditions);
  ASSERT_EQ(conditions.size(), 1U);
  EXPECT_EQ(conditions[0].severity, ConditionSeverity::warning);
  EXPECT_EQ(conditions[0].detail,
            "found 1764174008, 1.36e+08 times the median of 13; the first in row 5");
}

TEST(TimeRounding, MicrosecondsStayApartInEveryUnit) {
  for (const double origin : {0.0, 100.0, 1e5, 1764174000.0}) {
    SurvivalOutcome outcome = events_at({origin + 2e-6, origin + 4e-6, origin + 6e-6});
    round_times(outcome);
    EXPECT_EQ(distinct(outcome.stop), 3U) << origin;
  }
  // Nanoseconds as seconds, R makes them one; stamps in milliseconds and nanoseconds.
  for (const std::vector<double>& times : {std::vector<double>{1e-9, 2e-9, 3e-9},
                                           {1764174000000.0, 1764174000001.0},
                                           {1764174000000000000.0, 1764174000000100000.0}}) {
    SurvivalOutcome outcome = events_at(times);
    round_times(outcome);
    EXPECT_EQ(outcome.stop, times);
  }
}

TEST(TimeRounding, NoChain) {
  std::vector<double> times;
  for (int k = 0; k < 100; ++k) {
    times.push_back(100.0 + 4e-7 * k);
  }
  SurvivalOutcome outcome = events_at(times);
  const TimeRounding rounding = round_times(outcome);
  EXPECT_EQ(rounding.by_timefix, 1U);
  EXPECT_EQ(distinct(outcome.stop), 50U);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_LE(times[i] - outcome.stop[i], 5e-7);
    EXPECT_GE(times[i], outcome.stop[i]);
  }
}

TEST(TimeRounding, AStepIsFoundAgainByATimeThatIsItButForRounding) {
  table::RandomStream random(3, 1, 0);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> steps;
    for (int k = 0; k < 12; ++k) {
      steps.push_back(1e-3 * random.below(20'000) + 3e-7 * random.below(3));
    }
    std::sort(steps.begin(), steps.end());
    const double asked = steps[random.below(12)] + 4e-7 * (random.uniform() - 0.5);
    // Slowly: the nearest of all that are the same.
    double expected = asked;
    double least = INFINITY;
    for (const double step : steps) {
      if (same_time(asked, step) && std::abs(step - asked) < least) {
        least = std::abs(step - asked);
        expected = step;
      }
    }
    EXPECT_EQ(step_time(steps, asked, [](double t) { return t; }), expected);
  }
}

TEST(TimeRounding, CurvesAreReadAtTheStepThatWasPrinted) {
  const auto curve = survival_curves(events_at({0.1 + 0.2, 1.0, 12.344490000000008}))[0];
  EXPECT_EQ(curve.at(0.3), curve.points.data());
  EXPECT_EQ(curve.at(0.2999), nullptr);
  EXPECT_EQ(curve.at(12.34449), curve.points.data() + 2);
  EXPECT_EQ(curve.at(12.3444), curve.points.data() + 1);
}

TEST(UnlikeTimes, FindsStampsAmongDurationsAndDurationsAmongStamps) {
  EXPECT_FALSE(table::unlike_times(std::vector<double>{}));
  EXPECT_FALSE(table::unlike_times(std::vector<double>{0.01, 5, 9, 200}));
  EXPECT_FALSE(table::unlike_times(std::vector<double>{1.7e9, 1.7e9 + 5}));
  EXPECT_TRUE(table::are_stamps(std::vector<double>{1.7e9, 1.7e9 + 36'000}));
  EXPECT_FALSE(table::are_stamps(std::vector<double>{1.7e9, 36.0}));
  EXPECT_FALSE(table::are_stamps(std::vector<double>{1.7e9}));
  const auto above = table::unlike_times(std::vector<double>{5, 1.7e9, 9, 7, 1.8e9}).value();
  EXPECT_EQ(above.first, 1U);
  EXPECT_EQ(above.time, 1.8e9);
  EXPECT_EQ(above.count, 2U);
  EXPECT_EQ(above.median, 9.0);
  const auto below = table::unlike_times(std::vector<double>{1.7e9, 1.7e9, 5, 7, 1.8e9}).value();
  EXPECT_EQ(below.first, 2U);
  EXPECT_EQ(below.time, 5.0);
}

}  // namespace
}  // namespace tcert::statistics
