#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/certifier.hpp>
#include <tcert/footing.hpp>

#include "support/random_run.hpp"

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Footing pitched(double slope) { return {std::atan(slope), 0.0, kMissing, kMissing}; }
Footing stepped(double step_m) { return {kMissing, kMissing, step_m, kMissing}; }
Footing slipping(double slip) { return {kMissing, kMissing, kMissing, slip}; }

TEST(Footing, SlacksByHand) {
  const CertificateParameters p;  // 1.0, 0.4 / (2 x 0.2) = 1.0, 0.12 m and 0.5
  constexpr double s = 1.6;
  EXPECT_NEAR(footing_slack(pitched(0.5), p, s), 0.5 * s, 1e-12);
  EXPECT_NEAR(footing_slack(stepped(0.06), p, s), 0.5 * s, 1e-12);
  EXPECT_NEAR(footing_slack(slipping(0.1), p, s), 0.8 * s, 1e-12);
  EXPECT_NEAR(footing_slack({std::atan(0.2), 0.0, 0.03, 0.3}, p, s), 0.4 * s, 1e-12) << "least";
  EXPECT_EQ(footing_slack({0.0, 0.0, 0.0, 0.0}, p, s), s);
  EXPECT_EQ(footing_slack({}, p, s), kInfinity);
  EXPECT_LT(footing_slack(pitched(1.5), p, s), 0.0);
}

TEST(Footing, ASlopeIsThatOfThePlaneWhicheverWayItIsFaced) {
  EXPECT_NEAR(slope_of(pitched(0.7)), 0.7, 1e-12);
  // A plane of slope 0.7 faced at 30 degrees: pitch, then roll about the pitched axis.
  const double along = 0.7 * std::cos(std::numbers::pi / 6.0);
  const double across = 0.7 * std::sin(std::numbers::pi / 6.0);
  const Footing faced{
      std::atan(along), std::atan(across / std::sqrt(1.0 + along * along)), kMissing, kMissing};
  EXPECT_NEAR(slope_of(faced), 0.7, 1e-12);
  EXPECT_NEAR(slope_of({std::atan(0.3), kMissing, 0.0, 0.0}), 0.3, 1e-12);
  EXPECT_TRUE(std::isnan(slope_of({kMissing, kMissing, 0.1, 0.1})));
  EXPECT_EQ(slope_of({1.6, 0.0, 0.0, 0.0}), kInfinity);
}

TEST(Footing, TipsByTheHeightOfTheCentreOrSlidesByFriction) {
  CertificateParameters p;
  p.friction = 0.5;
  EXPECT_NEAR(footing_slack(pitched(0.25), p, 2.0), 1.0, 1e-12);
  p.friction = 5.0;
  p.centre_height_m = 0.4;
  EXPECT_NEAR(footing_slack(pitched(0.25), p, 2.0), 1.0, 1e-12);
  p.centre_height_m = 0.0;  // never tips
  EXPECT_NEAR(footing_slack(pitched(2.5), p, 2.0), 1.0, 1e-12);
}

TEST(Footing, OfSeveralSamplesTheWorstAndOfMissingOnesTheLast) {
  Footing worst{0.1, kMissing, 0.02, kMissing};
  keep_worst({-0.2, 0.1, 0.01, kMissing}, worst);
  EXPECT_EQ(worst.pitch_rad, -0.2);
  EXPECT_EQ(worst.roll_rad, 0.1);
  EXPECT_EQ(worst.step_m, 0.02);
  EXPECT_TRUE(std::isnan(worst.slip));
  keep_worst({kMissing, kMissing, kInfinity, kMissing}, worst);
  EXPECT_EQ(worst.step_m, 0.02) << "what is not finite hides nothing";
  Footing last{0.1, 0.2, 0.3, 0.4};
  keep_known({kMissing, 0.5, kInfinity, kMissing}, last);
  EXPECT_EQ(last.pitch_rad, 0.1);
  EXPECT_EQ(last.roll_rad, 0.5);
  EXPECT_EQ(last.step_m, 0.3) << "what is not finite is not measured";
}

/// A run along a corridor 1.2 m wide, on whose third metre the ground is `footing`.
CertifiedTick certify_over(const Footing& footing, const CertificateParameters& parameters) {
  Robot robot;
  robot.rays = {{"left", {}, 0.5 * std::numbers::pi, 1.0, RayKind::range, {}},
                {"right", {}, -0.5 * std::numbers::pi, 1.0, RayKind::range, {}}};
  Certifier certifier(robot, {Disc{{0.0, 0.0}, 0.3}, Disc{{5.0, 0.0}, 0.3}}, parameters);
  const std::array<RayReading, 2> readings{{{0.6}, {0.6}}};
  CertifiedTick now;
  for (int k = 0; k <= 250; ++k) {
    const double x_m = 0.02 * k;
    Tick tick{k * std::int64_t{100'000'000}, {{x_m, 0.0}, 0.0}, readings};
    tick.footing = {0.0, 0.0, 0.0, 0.0};
    if (x_m > 2.0 && x_m < 3.0) {
      tick.footing = footing;
    }
    now = certifier.update(tick);
  }
  return now;
}

TEST(Footing, BoundsTheCertificateByMinComposition) {
  const CertificateParameters p;
  // s = 2 x 1.0 - 0.45, the largest margin of the two rays; the corridor's is 1.2 - 0.45.
  constexpr double s = 1.55;
  constexpr double wide = 0.75;
  EXPECT_NEAR(certify_over({0.0, 0.0, 0.0, 0.0}, p).certificate_m, wide, 1e-12) << "level";
  EXPECT_NEAR(certify_over(pitched(0.2), p).certificate_m, wide, 1e-12) << "0.8 s is above it";
  EXPECT_NEAR(certify_over(pitched(0.8), p).certificate_m, 0.2 * s, 1e-12);
  EXPECT_NEAR(certify_over(stepped(0.09), p).certificate_m, 0.25 * s, 1e-12);
  EXPECT_NEAR(certify_over(slipping(0.4), p).certificate_m, 0.2 * s, 1e-12);
  EXPECT_LT(certify_over(stepped(0.15), p).certificate_m, 0.0);
  EXPECT_FALSE(certify_over(stepped(0.15), p).issued);
  CertificateParameters plane;
  plane.footing = FootingReading::ignored;  // A4
  EXPECT_NEAR(certify_over(stepped(0.15), plane).certificate_m, wide, 1e-12);
  CertificateParameters scaled;
  scaled.footing_scale_m = 1.0;
  EXPECT_NEAR(certify_over(pitched(0.8), scaled).certificate_m, 0.2, 1e-12);
}

TEST(Footing, WhatIsFeltWhileARayIsSilentCounts) {
  Robot robot;
  robot.rays = {{"left", {}, 0.5 * std::numbers::pi, 1.0, RayKind::range, {}},
                {"right", {}, -0.5 * std::numbers::pi, 1.0, RayKind::range, {}}};
  Certifier certifier(robot, {Disc{{0.0, 0.0}, 0.3}, Disc{{5.0, 0.0}, 0.3}}, {});
  const std::array<RayReading, 2> readings{{{0.6}, {0.6}}};
  CertifiedTick now;
  for (int k = 0; k <= 250; ++k) {
    Tick tick{k * std::int64_t{100'000'000}, {{0.02 * k, 0.0}, 0.0}, readings};
    tick.stale = k >= 110 && k < 116;
    tick.footing = {0.0, 0.0, k == 112 ? 0.09 : 0.0, 0.0};
    now = certifier.update(tick);
  }
  EXPECT_NEAR(now.certificate_m, 0.25 * 1.55, 1e-12);
}

TEST(Footing, BoundsTheSweptAreaToo) {
  CertificateParameters swept;
  swept.clearance = ClearanceReading::swept;
  const double level_m = certify_over({0.0, 0.0, 0.0, 0.0}, swept).certificate_m;
  EXPECT_GT(level_m, 0.2);
  EXPECT_NEAR(certify_over(stepped(0.11), swept).certificate_m, 1.55 / 12.0, 1e-9);
}

TEST(Footing, LevelGroundChangesNoBitOfAnyRun) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const test_support::Run run = test_support::random_run(seed, 600);
    Certifier without(run.robot, run.course, {});
    Certifier level(run.robot, run.course, {});
    for (const Tick& tick : run.ticks) {
      Tick flat = tick;
      flat.footing = {0.0, 0.0, 0.0, 0.0};
      const CertifiedTick a = without.update(tick);
      const CertifiedTick b = level.update(flat);
      ASSERT_TRUE(a.margin_m == b.margin_m || std::isnan(a.margin_m));
      ASSERT_EQ(a.certificate_m, b.certificate_m);
      ASSERT_EQ(a.corridor_value_m, b.corridor_value_m);
      ASSERT_TRUE(std::isnan(a.footing_slack_m));
    }
  }
}

}  // namespace
}  // namespace tcert
