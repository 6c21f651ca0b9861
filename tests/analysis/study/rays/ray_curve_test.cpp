#include "analysis/study/rays/ray_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <table/random.hpp>
#include <vector>

#include "datasets/corpus/tentacles.hpp"

namespace tcert::study {
namespace {

const Calibration& corpus_curve() { return corpus_robot().rays.front().calibration; }

TEST(RayCurve, OfExactDataIsTheCurveItself) {
  std::vector<double> bend;
  std::vector<double> clearance;
  for (int i = 0; i <= 240; ++i) {
    bend.push_back(0.005 * i);
    clearance.push_back(calibrated_clearance(corpus_curve(), bend.back()));
  }
  const RayCurve curve = fit_ray_curve(bend, clearance, 12);
  EXPECT_EQ(curve.trend, statistics::Trend::falling);
  EXPECT_LT(curve.thinning_m, 1e-9);
  // Its knots but those at 0.35 and 0.6 rad, which lie on the line from 0.15 to 0.9.
  const std::vector<double> expected{0.0, 0.15, 0.9, 1.2};
  ASSERT_EQ(curve.calibration.bend_rad.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(curve.calibration.bend_rad[i], expected[i], 1e-12);
    EXPECT_NEAR(
        curve.calibration.clearance_m[i], calibrated_clearance(corpus_curve(), expected[i]), 1e-12);
  }
}

TEST(RayCurve, HasFewKnotsInOrderAndSaysWhatThinningCosts) {
  table::RandomStream random(4, 1, 1);
  std::vector<double> bend;
  std::vector<double> clearance;
  for (int i = 0; i < 3000; ++i) {
    bend.push_back(random.uniform(0.0, 1.2));
    clearance.push_back(std::sin(bend.back()) + 0.05 * random.normal());
  }
  for (const std::size_t most : {2U, 5U, 12U}) {
    const RayCurve curve = fit_ray_curve(bend, clearance, most);
    EXPECT_EQ(curve.trend, statistics::Trend::rising);
    const Calibration& knots = curve.calibration;
    EXPECT_LE(knots.bend_rad.size(), most);
    for (std::size_t i = 1; i < knots.bend_rad.size(); ++i) {
      EXPECT_GT(knots.bend_rad[i], knots.bend_rad[i - 1]);
      EXPECT_GE(knots.clearance_m[i], knots.clearance_m[i - 1]);
    }
    EXPECT_NEAR(curve.residual_m, 0.05, 0.005);
    const statistics::IsotonicFit fit = statistics::isotonic_fit(bend, clearance);
    double furthest = 0.0;
    for (const double one : bend) {
      furthest = std::max(furthest, std::abs(calibrated_clearance(knots, one) - fit.at(one)));
    }
    EXPECT_EQ(curve.thinning_m, furthest);
  }
}

TEST(RayCurve, OfOneBendIsOneKnot) {
  const std::vector<double> bend{0.3, 0.3, 0.3};
  const std::vector<double> clearance{1.0, 2.0, 3.0};
  const RayCurve curve = fit_ray_curve(bend, clearance, 12);
  EXPECT_EQ(curve.calibration.bend_rad, (std::vector<double>{0.3}));
  EXPECT_EQ(curve.calibration.clearance_m, (std::vector<double>{2.0}));
}

/// What is pasted into a bundle says exactly max(curve - q, 0) between the knots too.
TEST(Lowered, IsTheCurveLessTheQuantileAndNeverBelowNothing) {
  const Calibration rising{{0.0, 0.4, 1.0}, {0.02, 0.1, 0.5}};
  for (const Calibration& curve : {corpus_curve(), rising}) {
    for (const double by : {-0.03, 0.0, 0.013, 0.1, 0.25, 0.44}) {
      const Calibration low = lowered(curve, by);
      for (std::size_t i = 1; i < low.bend_rad.size(); ++i) {
        EXPECT_GT(low.bend_rad[i], low.bend_rad[i - 1]);
      }
      for (int i = -10; i <= 150; ++i) {
        const double bend = 0.01 * i;
        EXPECT_NEAR(calibrated_clearance(low, bend),
                    std::max(calibrated_clearance(curve, bend) - by, 0.0),
                    1e-12)
            << by << ' ' << bend;
      }
    }
  }
  const Calibration nothing = lowered(corpus_curve(), 1.0);
  EXPECT_EQ(nothing.clearance_m, (std::vector<double>{0.0}));
}

}  // namespace
}  // namespace tcert::study
