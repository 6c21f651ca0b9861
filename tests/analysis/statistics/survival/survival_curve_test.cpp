#include <statistics/survival/survival_curve.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

TEST(SurvivalCurve, MultipliesOutByHand) {
  // Times 1, 2, 2+, 3, 4+ of five rows: S = 4/5, 4/5 * 3/4 = 3/5, then 2 are left: 3/10.
  const SurvivalOutcome outcome{{}, {1, 2, 2, 3, 4}, {1, 1, 0, 1, 0}};
  const SurvivalCurve curve = survival_curves(outcome)[0];
  ASSERT_EQ(curve.points.size(), 4U);
  EXPECT_DOUBLE_EQ(curve.points[0].survival, 0.8);
  EXPECT_DOUBLE_EQ(curve.points[1].survival, 0.6);
  EXPECT_DOUBLE_EQ(curve.points[2].survival, 0.3);
  EXPECT_DOUBLE_EQ(curve.points[3].survival, 0.3);
  EXPECT_EQ(curve.points[2].at_risk, 2.0);
  EXPECT_EQ(curve.points[1].censored, 1.0);
  // Greenwood: 1/(5*4) + 1/(4*3) + 1/(2*1).
  EXPECT_NEAR(curve.points[2].log_std_error, std::sqrt(1.0 / 20 + 1.0 / 12 + 0.5), 1e-15);
  EXPECT_NEAR(curve.points[2].cumulative_hazard, 0.2 + 0.25 + 0.5, 1e-15);
  EXPECT_NEAR(curve.points[2].hazard_std_error, std::sqrt(0.04 + 0.0625 + 0.25), 1e-15);
  EXPECT_EQ(curve.at(0.5), nullptr);
  EXPECT_EQ(curve.at(2.5)->time, 2.0);
}

TEST(SurvivalCurve, HasItsMedianMidwayOfAFlatHalf) {
  // S = 3/4, 1/2, 1/4, 0 at 1, 2, 3, 4: it equals 1/2 from 2 to 3.
  const SurvivalOutcome outcome{{}, {1, 2, 3, 4}, {1, 1, 1, 1}};
  const SurvivalCurve curve = survival_curves(outcome)[0];
  EXPECT_EQ(survival_quantile(curve, 0.5).time, 2.5);
  EXPECT_EQ(survival_quantile(curve, 0.6).time, 3.0);
  EXPECT_FALSE(survival_quantile(curve, 0.5).high.has_value());
  EXPECT_THROW(static_cast<void>(survival_quantile(curve, 1.0)), std::invalid_argument);

  // The area under the steps up to 3.5: 1 + 3/4 + 1/2 + 1/8.
  EXPECT_DOUBLE_EQ(restricted_mean(curve, 3.5).mean, 2.375);
  EXPECT_DOUBLE_EQ(restricted_mean(curve, 0.5).mean, 0.5);
  EXPECT_EQ(restricted_mean(curve, 0.5).std_error, 0.0);
}

TEST(SurvivalCurve, CountsRowsAtRisk) {
  const SurvivalOutcome outcome{{0, 0, 2}, {1, 3, 5}, {1, 0, 1}};
  const std::vector<double> times{3, 0, 2, 5.5};
  const auto counts = numbers_at_risk(outcome, nullptr, times);
  EXPECT_EQ(counts[0], (std::vector<std::size_t>{2, 0, 1, 0}));
  const table::Factor groups{{0, 1, 1}, {"a", "b"}};
  EXPECT_EQ(numbers_at_risk(outcome, &groups, times)[1], (std::vector<std::size_t>{2, 0, 1, 0}));
}

TEST(SurvivalCurve, NamesWhatItCannotEstimate) {
  const table::Factor groups{{1, 1}, {"none", "some"}};
  CurveOptions options;
  options.groups = &groups;
  const auto curves = survival_curves({{}, {1, 2}, {0, 0}}, options);
  EXPECT_TRUE(has(curves[0].conditions, ConditionKind::no_rows));
  EXPECT_TRUE(curves[0].points.empty());
  EXPECT_TRUE(has(curves[1].conditions, ConditionKind::no_events));
  const std::vector<double> negative{1, -1};
  options.weights = negative;
  EXPECT_THROW(static_cast<void>(survival_curves({{}, {1, 2}, {0, 0}}, options)),
               std::invalid_argument);
}

struct Case {
  SurvivalOutcome outcome;
  std::vector<double> weights;
  table::Factor cluster;
};

Case random_case(std::uint64_t index) {
  table::RandomStream random(31, 1, index);
  Case rows;
  rows.cluster.levels = {"a", "b", "c", "d"};
  for (std::size_t row = 0; row < 25; ++row) {
    rows.outcome.start.push_back(random.below(3));
    rows.outcome.stop.push_back(rows.outcome.start.back() + 1.0 + random.below(7));
    rows.outcome.event.push_back(random.below(3) == 0 ? 0 : 1);
    rows.weights.push_back(0.5 + random.uniform());
    rows.cluster.codes.push_back(random.below(4));
  }
  if (index % 2 == 0) {
    rows.outcome.start.clear();
  }
  return rows;
}

SurvivalCurve curve_of(const Case& rows, CurveOptions options) {
  options.weights = rows.weights;
  return survival_curves(rows.outcome, options)[0];
}

TEST(SurvivalCurve, HasTheRobustErrorOfItsNumericalDerivatives) {
  for (std::uint64_t index = 0; index < 8; ++index) {
    const Case rows = random_case(index);
    CurveOptions options;
    options.cluster = &rows.cluster;
    options.survival = index < 4 ? SurvivalEstimate::kaplan_meier : SurvivalEstimate::exponential;
    options.hazard = index < 4 ? HazardEstimate::nelson_aalen : HazardEstimate::fleming_harrington;
    const SurvivalCurve curve = curve_of(rows, options);
    std::vector<std::vector<double>> survival(4, std::vector<double>(curve.points.size(), 0.0));
    auto hazard = survival;
    for (std::size_t row = 0; row < rows.weights.size(); ++row) {
      constexpr double kStep = 1e-5;
      Case more = rows;
      Case less = rows;
      more.weights[row] += kStep;
      less.weights[row] -= kStep;
      const SurvivalCurve up = curve_of(more, options);
      const SurvivalCurve down = curve_of(less, options);
      const double scale = rows.weights[row] / (2.0 * kStep);
      for (std::size_t k = 0; k < curve.points.size(); ++k) {
        survival[rows.cluster.codes[row]][k] +=
            scale * (up.points[k].survival - down.points[k].survival);
        hazard[rows.cluster.codes[row]][k] +=
            scale * (up.points[k].cumulative_hazard - down.points[k].cumulative_hazard);
      }
    }
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      double of_survival = 0.0;
      double of_hazard = 0.0;
      for (std::size_t c = 0; c < 4; ++c) {
        of_survival += survival[c][k] * survival[c][k];
        of_hazard += hazard[c][k] * hazard[c][k];
      }
      EXPECT_NEAR(curve.points[k].std_error(), std::sqrt(of_survival), 1e-8);
      EXPECT_NEAR(curve.points[k].hazard_std_error, std::sqrt(of_hazard), 1e-7);
    }
  }
}

TEST(SurvivalCurve, ARiskSetThatEmptiesLeavesNoRounding) {
  // 0.1 + 0.2 + 0.3 less 0.2 and 0.3 is no 0.1.
  const SurvivalOutcome outcome{{0, 1, 1}, {1, 2, 3}, {1, 1, 1}};
  const std::vector<double> weights{0.1, 0.2, 0.3};
  CurveOptions options;
  options.weights = weights;
  const SurvivalCurve curve = survival_curves(outcome, options)[0];
  EXPECT_EQ(curve.points[0].at_risk, 0.1);
  for (const SurvivalPoint& point : curve.points) {
    EXPECT_EQ(point.survival, 0.0);
    EXPECT_EQ(point.std_error(), 0.0);
  }
}

TEST(SurvivalInterval, HasNoEndsWhereItsScaleHasNone) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(survival_interval(0.0, kInf).low));
  EXPECT_TRUE(std::isnan(survival_interval(1.0, 0.0, IntervalScale::log_log).high));
  EXPECT_EQ(survival_interval(1.0, 0.0).low, 1.0);
  EXPECT_EQ(survival_interval(0.9, 1.0, IntervalScale::plain).high, 1.0);
  EXPECT_THROW(static_cast<void>(survival_interval(0.5, 0.1, IntervalScale::log, 0.0)),
               std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
