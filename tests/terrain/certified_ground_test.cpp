// The link of the two systems: what a corridor is worth on ground that is certified in part.
#include "analysis/study/trials/certified_ground.hpp"

#include <gtest/gtest.h>

#include <tcert/certifier.hpp>

#include "analysis/study/trials/certify_trial.hpp"

namespace tcert::study {
namespace {

/// Half a metre a cell, x from -2 to 8 m and y from -2 to 2 m; all certified but a strip.
TerrainGrid ground(double from_m, double to_m) {
  TerrainGrid safe{21, 9, std::vector<double>(21U * 9U, 1.0), {}};
  safe.frame = {-2.0, -2.0, false, 0.5, 0.5, true};
  for (int x = 0; x < safe.rows; ++x) {
    const double at = -2.0 + 0.5 * x;
    for (int y = 0; y < safe.columns; ++y) {
      if (at >= from_m && at <= to_m) {
        safe.values[static_cast<std::size_t>(x * safe.columns + y)] = 0.0;
      }
    }
  }
  return safe;
}

Robot robot() {
  Robot robot;
  robot.body_width_m = 0.4;
  robot.min_turn_radius_m = 0.2;
  robot.rays = {{"left", {0.0, 0.1}, 1.5707963267948966, 2.0, RayKind::range, {}},
                {"right", {0.0, -0.1}, -1.5707963267948966, 2.0, RayKind::range, {}}};
  return robot;
}

/// Five metres along the middle of a corridor one metre wide, at 0.1 m a tick.
TickTable straight_run() {
  TickTable ticks;
  ticks.rays = 2;
  for (int i = 0; i <= 50; ++i) {
    ticks.time_ns.push_back(i * 100'000'000LL);
    ticks.poses.push_back({{0.1 * i, 0.0}, 0.0});
    ticks.readings.push_back({0.4, kMissing, kMissing});
    ticks.readings.push_back({0.4, kMissing, kMissing});
    ticks.stale.push_back(0);
    ticks.segment_start.push_back(i == 0 ? 1 : 0);
    ticks.speed_cmd_mps.push_back(kMissing);
    ticks.yaw_rate_cmd_rps.push_back(kMissing);
  }
  return ticks;
}

double certificate_of(const TickTable& ticks) {
  Course course;
  course.start = Disc{{0.0, 0.0}, 0.5};
  course.goal = Disc{{5.0, 0.0}, 0.5};
  CertificateParameters parameters;
  parameters.memory_weight_m = 0.0;
  Certifier certifier(robot(), course, parameters);
  return certify_trial(certifier, ticks).ticks.back().certificate_m;
}

TEST(CertifiedGround, AllOfItLeavesTheCertificateAsItIs) {
  const CertifiedGround all(ground(100.0, 101.0), 0.4);
  const TickTable ticks = straight_run();
  const TickTable kept = all.ticks_on(ticks);
  ASSERT_EQ(ticks.size(), kept.size());
  EXPECT_EQ(ticks.segment_start, kept.segment_start);
  EXPECT_GT(certificate_of(ticks), 0.3);
  EXPECT_EQ(certificate_of(ticks), certificate_of(kept));
}

TEST(CertifiedGround, AStripAcrossTheCorridorIssuesNone) {
  for (const double width : {0.0, 1.0}) {
    const CertifiedGround with_strip(ground(2.0, 2.0 + width), 0.4);
    const TickTable kept = with_strip.ticks_on(straight_run());
    EXPECT_LT(kept.size(), straight_run().size());
    EXPECT_FALSE(certificate_of(kept) > 0.0);
    // The body stays half its width and half a cell from it.
    for (const Pose& pose : kept.poses) {
      EXPECT_TRUE(pose.position.x_m < 2.0 - 0.44 || pose.position.x_m > 2.0 + width + 0.44);
    }
  }
}

TEST(CertifiedGround, ASeamBetweenTwoTicksBreaksThePath) {
  // A strip that no tick lies on, but the way between two does.
  TickTable ticks = straight_run();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ticks.poses[i].position.x_m = i < 25 ? 0.0 : 5.0;
  }
  const CertifiedGround with_strip(ground(2.0, 2.0), 0.4);
  const TickTable kept = with_strip.ticks_on(ticks);
  ASSERT_EQ(ticks.size(), kept.size());
  EXPECT_EQ(1, kept.segment_start[25]);
}

TEST(CertifiedGround, NeedsAMapAndABody) {
  TerrainGrid nowhere = ground(2.0, 2.0);
  nowhere.frame.is_declared = false;
  EXPECT_THROW(CertifiedGround(nowhere, 0.4), std::invalid_argument);
  EXPECT_THROW(CertifiedGround(ground(2.0, 2.0), 0.0), std::invalid_argument);
  const CertifiedGround some(ground(2.0, 2.0), 0.4);
  EXPECT_FALSE(some.holds({1e12, 0.0}, {1e12, 0.0}));
  EXPECT_FALSE(some.holds({kMissing, 0.0}, {0.0, 0.0}));
}

}  // namespace
}  // namespace tcert::study
