#include "analysis/study/trials/certify_trial.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tcert::study {
namespace {

/// Straight along x from a disc at the origin to one at 3 m, walls felt 0.4 m to either side.
TickTable straight_run(double width_m) {
  TickTable ticks;
  ticks.rays = 2;
  for (int k = 0; k <= 160; ++k) {
    ticks.time_ns.push_back(k * 100'000'000LL);
    ticks.poses.push_back({{0.02 * k, 0.0}, 0.0});
    ticks.readings.push_back({0.5 * width_m, kMissing});
    ticks.readings.push_back({0.5 * width_m, kMissing});
    ticks.stale.push_back(0);
    ticks.segment_start.push_back(0);
  }
  return ticks;
}

Certifier certifier() {
  Robot robot;
  for (const double bearing : {std::numbers::pi / 2, -std::numbers::pi / 2}) {
    Ray ray;
    ray.name = bearing > 0 ? "left" : "right";
    ray.bearing_rad = bearing;
    ray.reach_m = 2.0;
    robot.rays.push_back(ray);
  }
  Course course;
  course.start = Disc{{0.0, 0.0}, 0.3};
  course.goal = Disc{{3.0, 0.0}, 0.3};
  return Certifier(robot, course, CertificateParameters{});
}

TEST(CertifyTrial, GivesOneRowPerTickAndTheBottleneck) {
  Certifier c = certifier();
  const TrialSeries series = certify_trial(c, straight_run(0.8));
  ASSERT_EQ(series.ticks.size(), 161U);
  EXPECT_TRUE(series.ticks.back().issued);
  EXPECT_NEAR(series.ticks.back().certificate_m, 0.8 - 0.45, 1e-12);
  ASSERT_TRUE(series.bottleneck.has_value());
  EXPECT_NEAR(series.bottleneck->width_m, 0.8, 1e-12);
}

TEST(CertifyTrial, RemembersNothingOfTheTrialBefore) {
  Certifier c = certifier();
  const TrialSeries first = certify_trial(c, straight_run(0.8));
  const TrialSeries narrow = certify_trial(c, straight_run(0.4));
  EXPECT_FALSE(narrow.ticks.back().issued);
  const TrialSeries again = certify_trial(c, straight_run(0.8));
  ASSERT_EQ(again.ticks.size(), first.ticks.size());
  for (std::size_t i = 0; i < first.ticks.size(); ++i) {
    EXPECT_EQ(again.ticks[i].certificate_m, first.ticks[i].certificate_m);
    EXPECT_EQ(again.ticks[i].corridor_value_m, first.ticks[i].corridor_value_m);
    EXPECT_EQ(again.ticks[i].nodes, first.ticks[i].nodes);
  }
}

TEST(CertifyTrial, HasNoBottleneckWithoutAConnection) {
  Certifier c = certifier();
  TickTable ticks = straight_run(0.8);
  ticks.time_ns.resize(50);
  ticks.poses.resize(50);
  ticks.stale.resize(50);
  ticks.segment_start.resize(50);
  ticks.readings.resize(100);
  EXPECT_FALSE(certify_trial(c, ticks).bottleneck.has_value());
  EXPECT_TRUE(certify_trial(c, TickTable{}).ticks.empty());
}

}  // namespace
}  // namespace tcert::study
