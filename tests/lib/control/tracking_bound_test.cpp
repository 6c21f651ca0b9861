#include <gtest/gtest.h>

#include <cmath>
#include <tcert/tracking_bound.hpp>

namespace tcert {
namespace {

// By hand: v^2 / a of a braking distance twice over, that is, of a robot that must stop and come
// back.
TEST(TrackingBound, HasTheValuesOfTheClosedForm) {
  const auto radius = [](double v, double dv, double a, double da) {
    return tracking_radius_m({a, da, dv, 0.0}, v);
  };
  EXPECT_NEAR(radius(0.08, 0.0, 1.0, 0.0), 0.0064, 1e-15);
  EXPECT_NEAR(radius(0.22, 0.0, 1.0, 0.0), 0.0484, 1e-15);
  EXPECT_NEAR(radius(0.22, 0.05, 1.0, 0.1), 0.081, 1e-15);
  EXPECT_NEAR(radius(0.22, 0.02, 0.5, 0.05), 0.128, 1e-15);
  // v_exp (2 v + v_exp / 2) / (a - d_a) more: 0.1 (0.44 + 0.05) / 0.9.
  EXPECT_NEAR(tracking_radius_m({1.0, 0.1, 0.05, 0.1}, 0.22), 0.081 + 0.049 / 0.9, 1e-15);
  EXPECT_NEAR(tracking_hold_s({0.5, 0.05, 0.02, 0.0}, 0.22), 0.24 / 0.45, 1e-15);
}

TEST(TrackingBound, HasNoBoundWhereTheDisturbanceTakesAllBraking) {
  for (const DoubleIntegrator model : {DoubleIntegrator{1.0, 1.0, 0.0, 0.0},
                                       DoubleIntegrator{1.0, 2.0, 0.0, 0.0},
                                       DoubleIntegrator{std::nan(""), 0.0, 0.0, 0.0}}) {
    EXPECT_EQ(tracking_radius_m(model, 0.1), INFINITY);
    EXPECT_EQ(tracking_hold_s(model, 0.1), INFINITY);
  }
  EXPECT_EQ(tracking_radius_m({}, -0.1), INFINITY);
  EXPECT_EQ(tracking_radius_m({}, std::nan("")), INFINITY);
}

// Chords of a convex function: in the speed, in the level of the disturbance (that is, of d_v and
// d_a at once), and in the speed just left, of which the table has r(max(v, v_left)).
TEST(TrackingBound, IsNeverAboveItsLinearInterpolation) {
  const auto at = [](double v, double level) {
    return tracking_radius_m({0.8, 0.3 * level, 0.1 * level, 0.05}, v);
  };
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 50; ++j) {
      const double a = 0.013 * i;
      const double b = a + 0.02 * (j + 1);
      for (const double share : {0.1, 0.37, 0.5, 0.92}) {
        const double between = std::lerp(a, b, share);
        EXPECT_GE(std::lerp(at(a, 1.0), at(b, 1.0), share), at(between, 1.0) - 1e-15);
        EXPECT_GE(std::lerp(at(0.2, a), at(0.2, b), share), at(0.2, between) - 1e-15);
        EXPECT_GE(std::lerp(at(std::max(0.2, a), 1.0), at(std::max(0.2, b), 1.0), share),
                  at(std::max(0.2, between), 1.0) - 1e-15);
        EXPECT_GE(at(b, 0.5), at(a, 0.5)) << "it rises";
      }
    }
  }
}

}  // namespace
}  // namespace tcert
