#include "datasets/driven/wedge_watch.hpp"

#include <gtest/gtest.h>

namespace tcert {
namespace {

/// Times in steps of 10 ms.
class Story {
 public:
  explicit Story(const DriveParameters& parameters) : watch(parameters, {}) {}
  void go(double seconds, double speed_cmd_mps, bool touches, Point from, Point to) {
    const int steps = static_cast<int>(seconds * 100.0 + 0.5);
    for (int i = 1; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      watch.watch(0.01, speed_cmd_mps, touches, from + share * (to - from));
      time_s += 0.01;
      if (watch.wedged() && wedged_s < 0.0) {
        wedged_s = time_s;
      }
    }
  }
  WedgeWatch watch;
  double time_s = 0.0;
  double wedged_s = -1.0;
};

// Stalls at 5, 10, 15 and 20 s; the last says that three attempts have failed; 5 s later it is out.
TEST(WedgeWatch, GivesUpOnARobotThatOnlyPushesAfterFiveStalls) {
  const DriveParameters parameters;
  Story story(parameters);
  story.go(40.0, 0.2, true, {0.0, 0.0}, {0.0, 0.0});
  EXPECT_NEAR(story.wedged_s, 25.0, 0.051);
  EXPECT_EQ(story.watch.recoveries(), 0U);
}

TEST(WedgeWatch, SaysNothingOfARobotThatStandsOrCreepsOn) {
  const DriveParameters parameters;
  Story standing(parameters);
  standing.go(100.0, 0.0, true, {0.0, 0.0}, {0.0, 0.0});
  EXPECT_EQ(standing.watch.stalls(), 0U);
  Story creeping(parameters);
  creeping.go(100.0, 0.2, true, {0.0, 0.0}, {0.5, 0.0});  // 2.5 cm in 5 s
  EXPECT_EQ(creeping.watch.stalls(), 0U);
  EXPECT_LT(creeping.wedged_s, 0.0);
  Story slower(parameters);
  slower.go(100.0, 0.2, true, {0.0, 0.0}, {0.3, 0.0});  // 1.5 cm in 5 s
  EXPECT_GT(slower.watch.stalls(), 0U);
}

// Cycles of 1.5 s of forward command: stops at the reversals 1, 2, 3, 4 (three have failed), then
// 6 s until reversal 8.
TEST(WedgeWatch, CountsRecoveriesThatLeadBackToTheSamePlace) {
  const DriveParameters parameters;
  Story story(parameters);
  for (int i = 0; i < 12; ++i) {
    story.go(1.5, 0.15, true, {0.0, 0.0}, {0.15, 0.0});
    story.go(1.5, -0.1, false, {0.15, 0.0}, {0.0, 0.0});
    if (i == 6) {
      EXPECT_LT(story.wedged_s, 0.0);
    }
  }
  EXPECT_NEAR(story.wedged_s, 7 * 3.0 + 1.5, 0.1);
  EXPECT_GE(story.watch.recoveries(), 8U);
  EXPECT_EQ(story.watch.stalls(), 0U);
}

TEST(WedgeWatch, ForgetsThePlaceOfARobotThatGotAway) {
  const DriveParameters parameters;
  Story story(parameters);
  for (int i = 0; i < 12; ++i) {
    story.go(3.0, 0.15, true, {-0.35, 0.0}, {0.0, 0.0});
    story.go(3.0, -0.1, false, {0.0, 0.0}, {-0.35, 0.0});
  }
  EXPECT_LT(story.wedged_s, 0.0);
  EXPECT_EQ(story.watch.recoveries(), 12U);
}

// A reversal without a touch before is no recovery.
TEST(WedgeWatch, TakesAReversalInTheOpenForNone) {
  const DriveParameters parameters;
  Story story(parameters);
  for (int i = 0; i < 12; ++i) {
    story.go(1.5, 0.1, false, {0.0, 0.0}, {0.15, 0.0});
    story.go(1.5, -0.1, false, {0.15, 0.0}, {0.0, 0.0});
  }
  EXPECT_EQ(story.watch.recoveries(), 0U);
  EXPECT_LT(story.wedged_s, 0.0);
}

}  // namespace
}  // namespace tcert
