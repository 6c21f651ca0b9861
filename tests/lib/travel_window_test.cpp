#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tcert/travel_window.hpp>
#include <utility>

namespace tcert {
namespace {

TEST(TrailingMinimum, ForgetsWhatLiesFurtherBackThanItsWindow) {
  TrailingMinimum minimum(0.5, 0.01);
  EXPECT_EQ(minimum.add(0.0, 0.3), 0.3);
  EXPECT_EQ(minimum.add(0.2, 0.9), 0.3);
  EXPECT_EQ(minimum.add(0.5, 0.8), 0.3);   // 0.5 back still counts
  EXPECT_EQ(minimum.add(0.51, 0.9), 0.8);  // 0.51 back does not
  EXPECT_EQ(minimum.add(0.51, 0.4), 0.4);  // standing still adds to the same travel
}

TEST(TrailingMinimum, EqualsTheMinimumOverAllThatIsInTheWindow) {
  std::mt19937 bits(7);
  TrailingMinimum minimum(0.45, 0.01);
  std::vector<std::pair<double, double>> all;
  double travel_m = 0.0;
  for (int k = 0; k < 20'000; ++k) {
    travel_m += bits() % 3 == 0 ? 0.0 : 0.01 + 0.01 * static_cast<double>(bits() % 4);
    const double value = static_cast<double>(bits() % 10);
    all.emplace_back(travel_m, value);
    double expected = value;
    for (auto it = all.rbegin(); it != all.rend() && travel_m - it->first <= 0.45 + 1e-9; ++it) {
      expected = std::min(expected, it->second);
    }
    ASSERT_EQ(minimum.add(travel_m, value), expected) << "step " << k;
  }
}

TEST(TrailingMotion, IsTheNetChangeSinceTheWindowBegan) {
  TrailingMotion motion(0.25, 0.01);
  motion.add({0.0, 0.0, 1.0});
  motion.add({0.0, 0.1, 1.0});  // turning on the spot at the same travel counts
  const TrailingMotion::Motion moved = motion.add({0.2, 0.5, 1.2});
  EXPECT_EQ(moved.travel_m, 0.2);
  EXPECT_EQ(moved.yaw_rad, 0.5);
  EXPECT_NEAR(moved.across_m, 0.2, 1e-15);
  const TrailingMotion::Motion later = motion.add({0.3, 0.6, 1.3});
  EXPECT_NEAR(later.travel_m, 0.1, 1e-15);
  EXPECT_NEAR(later.yaw_rad, 0.1, 1e-15);
  EXPECT_NEAR(later.across_m, 0.1, 1e-15);
}

// 0.1 + 0.2 is more than 0.3 in floating point, and a window of 0.3 m still holds both.
TEST(TrailingMinimum, DoesNotHangOnTheLastBit) {
  TrailingMinimum window(0.3, 0.01);
  window.add(0.0, 1.0);
  window.add(0.1, 2.0);
  EXPECT_EQ(window.add(0.1 + 0.2, 3.0), 1.0);
  EXPECT_EQ(window.add(0.301, 3.0), 2.0);
}

}  // namespace
}  // namespace tcert
