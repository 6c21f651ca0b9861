#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <tcert/line_follower.hpp>

namespace tcert::policies {
namespace {

constexpr Point kGoal{4.0, 0.0};

// A square lobe of two lanes, then a straight one.
CourseLine course() {
  CourseLine line;
  line.low = {-1.0, -2.0};
  line.high = {5.0, 2.0};
  line.lobes = {{{{{0.0, 0.0}, {0.0, 1.0}, {2.0, 1.0}, {2.0, 0.0}},
                  {{0.0, 0.0}, {0.0, -1.0}, {2.0, -1.0}, {2.0, 0.0}}}},
                {{{{2.0, 0.0}, {3.0, 0.0}}}}};
  return line;
}

void expect_near(Point p, Point expected) {
  EXPECT_NEAR(p.x_m, expected.x_m, 1e-12);
  EXPECT_NEAR(p.y_m, expected.y_m, 1e-12);
}

TEST(LineFollower, AimsAheadOnTheLane) {
  LineFollower line(course(), 0.4);
  expect_near(line.carrot({0.0, 0.0}, kGoal), {0.0, 0.4});
  expect_near(line.carrot({0.1, 0.3}, kGoal), {0.0, 0.7});
  expect_near(line.carrot({-0.1, 0.8}, kGoal), {0.2, 1.0});
  expect_near(line.carrot({-0.1, 0.6}, kGoal), {0.0, 1.0});  // pushed back
}

TEST(LineFollower, GoesFromLobeToLobeAndThenForTheGoal) {
  LineFollower line(course(), 0.4);
  for (const Point p :
       {Point{0.0, 0.0}, {0.0, 0.6}, {0.2, 1.0}, {0.9, 1.0}, {1.6, 1.0}, {2.0, 0.7}}) {
    EXPECT_EQ(line.lobe(), 0U);
    static_cast<void>(line.carrot(p, kGoal));
  }
  expect_near(line.carrot({2.0, 0.3}, kGoal), {2.1, 0.0});
  EXPECT_EQ(line.lobe(), 0U);
  expect_near(line.carrot({2.0, 0.05}, kGoal), {2.4, 0.0});
  EXPECT_EQ(line.lobe(), 1U);
  expect_near(line.carrot({2.7, 0.0}, kGoal), kGoal);
  expect_near(line.carrot({2.95, 0.0}, kGoal), kGoal);
  EXPECT_EQ(line.lobe(), 2U);
  expect_near(line.carrot({3.9, 0.0}, kGoal), kGoal);
}

TEST(LineFollower, LeadsBackAndIntoTheOtherLane) {
  LineFollower line(course(), 0.4);
  static_cast<void>(line.carrot({0.0, 0.7}, kGoal));
  line.give_up_lane();
  EXPECT_TRUE(line.backing_out());
  expect_near(line.carrot({0.0, 0.7}, kGoal), {0.0, 0.3});
  line.give_up_lane();  // on the way back it has no meaning
  EXPECT_EQ(line.lane(), 0U);
  expect_near(line.carrot({0.0, 0.45}, kGoal), {0.0, 0.05});
  expect_near(line.carrot({0.0, 0.35}, kGoal), {0.0, -0.4});
  EXPECT_FALSE(line.backing_out());
  EXPECT_EQ(line.lane(), 1U);
  line.give_up_lane();
  static_cast<void>(line.carrot({0.0, 0.0}, kGoal));
  EXPECT_EQ(line.lane(), 0U) << "in turn";
}

TEST(LineFollower, ALaneAloneIsNotGivenUp) {
  CourseLine only = course();
  only.lobes[0].lanes.resize(1);
  LineFollower line(only, 0.4);
  line.give_up_lane();
  EXPECT_FALSE(line.backing_out());
  expect_near(line.carrot({0.0, 0.0}, kGoal), {0.0, 0.4});
}

TEST(LineFollower, WithoutALineAimsAtTheGoal) {
  CourseLine none;
  LineFollower line(none, 0.4);
  line.give_up_lane();
  EXPECT_EQ(line.carrot({0.0, 0.0}, kGoal), kGoal);
}

TEST(LineFollower, ResetBeginsAnew) {
  LineFollower line(course(), 0.4);
  static_cast<void>(line.carrot({0.0, 0.7}, kGoal));
  line.give_up_lane();
  line.reset();
  EXPECT_FALSE(line.backing_out());
  expect_near(line.carrot({0.0, 0.0}, kGoal), {0.0, 0.4});
}

TEST(CourseLine, RefusesLinesThatAreNone) {
  EXPECT_NO_THROW(validate(course()));
  const auto refuses = [](auto change) {
    CourseLine line = course();
    change(line);
    EXPECT_THROW(validate(line), std::invalid_argument);
  };
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  refuses([](CourseLine& l) { l.low.x_m = l.high.x_m; });
  refuses([](CourseLine& l) { l.high.y_m = kNaN; });
  refuses([](CourseLine& l) { l.high.y_m = 1e300; });
  refuses([](CourseLine& l) { l.lobes[1].lanes.clear(); });
  refuses([](CourseLine& l) { l.lobes[0].lanes[1].resize(1); });
  refuses([](CourseLine& l) { l.lobes[0].lanes[1][1] = l.lobes[0].lanes[1][0]; });
  refuses([](CourseLine& l) { l.lobes[0].lanes[1][1].x_m = kNaN; });
  refuses([](CourseLine& l) { l.lobes[0].lanes[1][1].x_m = 6.0; });
  refuses([](CourseLine& l) { l.lobes.resize(kMostLobes + 1, l.lobes[0]); });
  refuses([](CourseLine& l) { l.lobes[0].lanes.resize(kMostLanes + 1, l.lobes[0].lanes[0]); });
}

}  // namespace
}  // namespace tcert::policies
