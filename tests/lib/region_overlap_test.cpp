#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <tcert/region_overlap.hpp>
#include <tcert/robot.hpp>

namespace tcert {
namespace {

Region box(double x_m, double y_m, double half_m) {
  return Polygon{{{x_m - half_m, y_m - half_m},
                  {x_m + half_m, y_m - half_m},
                  {x_m + half_m, y_m + half_m},
                  {x_m - half_m, y_m + half_m}}};
}

TEST(RegionOverlap, RegionsThatTouchOrLieInEachOtherOverlap) {
  EXPECT_TRUE(touch(Disc{{0, 0}, 1}, Disc{{2, 0}, 1}));
  EXPECT_FALSE(touch(Disc{{0, 0}, 1}, Disc{{2.001, 0}, 1}));
  EXPECT_TRUE(touch(Disc{{0, 0}, 3}, Disc{{1, 0}, 0.1}));
  EXPECT_TRUE(touch(box(0, 0, 1), Disc{{2, 0}, 1}));
  EXPECT_FALSE(touch(box(0, 0, 1), Disc{{1.8, 1.8}, 1}));
  EXPECT_TRUE(touch(Disc{{0, 0}, 0.1}, box(0, 0, 5)));
  EXPECT_TRUE(touch(box(0, 0, 1), box(2, 0, 1)));
  EXPECT_TRUE(touch(box(0, 0, 1), box(0.2, 0.1, 0.1)));
  EXPECT_FALSE(touch(box(0, 0, 1), box(2.01, 0, 1)));
  const Region tall = Polygon{{{-0.1, -3}, {0.1, -3}, {0.1, 3}, {-0.1, 3}}};
  const Region wide = Polygon{{{-3, -0.1}, {3, -0.1}, {3, 0.1}, {-3, 0.1}}};
  EXPECT_TRUE(touch(tall, wide)) << "a cross: no vertex of one lies in the other";
}

// Points of either region, a fine grid of them, that lie in the other.
TEST(RegionOverlap, AgreesWithAGridOfPoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  std::uniform_real_distribution<double> size(0.3, 1.2);
  const auto any = [&]() -> Region {
    const Point centre{place(random), place(random)};
    if (random() % 2 == 0) {
      return Disc{centre, size(random)};
    }
    Polygon polygon;
    const double turn_rad = place(random);
    const std::size_t corners = 3 + random() % 4;
    for (std::size_t k = 0; k < corners; ++k) {
      const double at_rad =
          turn_rad + 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
      polygon.vertices.push_back(centre + size(random) * direction(at_rad));
    }
    return polygon;
  };
  int overlapping = 0;
  for (int round = 0; round < 300; ++round) {
    const Region a = any();
    const Region b = any();
    bool shared = false;
    for (double x_m = -3.4; x_m <= 3.4 && !shared; x_m += 0.02) {
      for (double y_m = -3.4; y_m <= 3.4 && !shared; y_m += 0.02) {
        shared = contains(a, {x_m, y_m}) && contains(b, {x_m, y_m});
      }
    }
    EXPECT_EQ(touch(a, b), touch(b, a));
    if (shared) {
      ++overlapping;
      EXPECT_TRUE(touch(a, b)) << round;
    }
  }
  EXPECT_GT(overlapping, 60);
  EXPECT_LT(overlapping, 240);
}

TEST(RegionOverlap, ACourseWhoseRegionsOverlapIsRefused) {
  Course course{Disc{{0, 0}, 0.5}, Disc{{0.9, 0}, 0.5}};
  EXPECT_THROW(validate(course), std::invalid_argument);
  course.goal = Disc{{1.1, 0}, 0.5};
  EXPECT_NO_THROW(validate(course));
}

}  // namespace
}  // namespace tcert
