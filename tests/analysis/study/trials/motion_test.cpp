#include "analysis/study/trials/motion.hpp"

#include <gtest/gtest.h>

#include <table/random.hpp>
#include <vector>

namespace tcert::study {
namespace {

constexpr std::int64_t kTick = 100'000'000;

TEST(TrailingMotion, MeasuresOverTheNewestPositionOldEnough) {
  // 0.01 m a tick of 0.1 s; the window of 0.25 s reaches back three ticks.
  std::vector<TimedPosition> path;
  for (int k = 0; k < 6; ++k) {
    path.push_back({k * kTick, {0.01 * k, 0.0}, false});
  }
  const std::vector<Motion> motion = trailing_motion(path, 250'000'000);
  EXPECT_FALSE(motion[2].speed_mps.has_value());
  EXPECT_NEAR(motion[3].speed_mps.value(), 0.1, 1e-12);
  EXPECT_NEAR(motion[5].speed_mps.value(), 0.1, 1e-12);
  EXPECT_EQ(motion[0].step_ns, 0);
  EXPECT_EQ(motion[1].step_ns, kTick);
}

TEST(TrailingMotion, StartsAnewAfterABreak) {
  std::vector<TimedPosition> path;
  for (int k = 0; k < 8; ++k) {
    path.push_back({k * kTick, {k < 4 ? 0.0 : 9.0, 0.0}, k == 4});
  }
  const std::vector<Motion> motion = trailing_motion(path, 2 * kTick);
  EXPECT_EQ(motion[3].speed_mps, 0.0);
  EXPECT_FALSE(motion[4].speed_mps.has_value());
  EXPECT_EQ(motion[4].step_ns, 0);
  EXPECT_FALSE(motion[5].speed_mps.has_value());
  EXPECT_EQ(motion[6].speed_mps, 0.0) << "the jump is no motion";
}

TEST(TrailingMotion, TakesPoseNoiseAtAStandstillForNoMotion) {
  table::RandomStream random(3, 0, 0);
  std::vector<TimedPosition> path;
  for (int k = 0; k < 2000; ++k) {
    path.push_back({k * kTick, {0.002 * random.normal(), 0.002 * random.normal()}, false});
  }
  int moving = 0;
  for (const Motion& motion : trailing_motion(path, 5 * kTick)) {
    moving += motion.speed_mps.value_or(0.0) >= 0.02 ? 1 : 0;
  }
  EXPECT_LT(moving, 10) << "of 2,000";
  int moving_by_tick = 0;
  for (const Motion& motion : trailing_motion(path, kTick)) {
    moving_by_tick += motion.speed_mps.value_or(0.0) >= 0.02 ? 1 : 0;
  }
  EXPECT_GT(moving_by_tick, 1000) << "tick by tick, most of a standstill looks like motion";
}

TEST(TrailingMotion, HasNothingToSayOfNoPath) { EXPECT_TRUE(trailing_motion({}, kTick).empty()); }

}  // namespace
}  // namespace tcert::study
