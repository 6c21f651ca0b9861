#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <tcert/tracking_error.hpp>

namespace tcert {
namespace {

TEST(TrackingErrorTable, InterpolatesBetweenEightKnots) {
  // r = 1 + 2 v + 3 a + 4 d at the corners of the unit cube: trilinear, so the same within it.
  TrackingErrorGrid grid{{0.0, 1.0}, {0.0, 1.0}, {0.0, 1.0}, {1, 5, 4, 8, 3, 7, 6, 10}};
  const TrackingErrorTable table(grid);
  EXPECT_EQ(table.radius_m(0, 0, 0), 1.0);
  EXPECT_EQ(table.radius_m(1, 1, 1), 10.0);
  EXPECT_EQ(table.radius_m(0, 0, 1), 5.0);
  EXPECT_NEAR(table.radius_m(0.5, 0.25, 0.75), 1 + 1 + 0.75 + 3, 1e-15);
}

TEST(TrackingErrorTable, HasNoBoundBeyondItsGrid) {
  const TrackingErrorTable table;
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(table.radius_m(0.51, 0, 0), infinity);
  EXPECT_EQ(table.radius_m(0, 5.1, 0), infinity);
  EXPECT_EQ(table.radius_m(0, 0, 1.1), infinity);
  EXPECT_EQ(table.radius_m(nan, 0, 0), infinity);
  EXPECT_LT(table.radius_m(0.5, 5, 1), infinity);
}

TEST(TrackingErrorTable, IsTheWayOfALoopAndATickUnlessMeasured) {
  const TrackingErrorTable table;
  EXPECT_EQ(table.radius_m(0, 0, 0), 0.0);
  EXPECT_NEAR(table.radius_m(0.2, 0, 0), 0.2 * 0.02, 1e-15);
  EXPECT_NEAR(table.radius_m(0.2, 2.0, 0.5), 1.5 * (0.2 * 0.02 + 2.0 * 0.005), 1e-15);
}

TEST(TrackingErrorTable, NeverFallsAlongAnAxis) {
  std::mt19937 random(1);
  const auto uniform = [&](double high) {
    return high * static_cast<double>(random()) / 4294967295.0;
  };
  const TrackingErrorTable table;
  for (int i = 0; i < 10'000; ++i) {
    const double v = uniform(0.4);
    const double a = uniform(4.0);
    const double d = uniform(0.9);
    const double here = table.radius_m(v, a, d);
    ASSERT_GE(table.radius_m(v + uniform(0.1), a, d), here);
    ASSERT_GE(table.radius_m(v, a + uniform(1.0), d), here);
    ASSERT_GE(table.radius_m(v, a, d + uniform(0.1)), here);
  }
}

TEST(TrackingErrorTable, RefusesAGridThatIsNoBound) {
  const auto refused = [](const TrackingErrorGrid& grid) {
    EXPECT_THROW(TrackingErrorTable{grid}, std::invalid_argument);
  };
  refused({{0.0, 1.0}, {0.0}, {0.0}, {0.2, 0.1}});
  refused({{0.0, 1.0}, {0.0}, {0.0}, {0.1}});
  refused({{0.1, 1.0}, {0.0}, {0.0}, {0.1, 0.1}});
  refused({{0.0, 0.0}, {0.0}, {0.0}, {0.1, 0.1}});
  refused({{0.0}, {}, {0.0}, {}});
  refused({{0.0}, {0.0}, {0.0}, {-0.1}});
}

}  // namespace
}  // namespace tcert
