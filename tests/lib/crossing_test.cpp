#include <gtest/gtest.h>

#include <cmath>
#include <tcert/crossing.hpp>

namespace tcert {
namespace {

// With y'' = a up to some way t and -a after it, or the other way round, a path gets to a slope and
// a rise at the way 2 l: both at once only for the a of the formula.
TEST(JoinCurvature, IsWhatTwoParabolasNeed) {
  for (const double length_m : {0.15, 0.25, 1.0}) {
    for (const double offset_m : {0.0, 0.02, -0.1, 0.15}) {
      for (const double off_axis_rad : {0.0, 0.1, 0.34}) {
        const double a = join_curvature(offset_m, off_axis_rad, length_m);
        if (a == 0.0) {
          EXPECT_EQ(offset_m, 0.0);
          EXPECT_EQ(off_axis_rad, 0.0);
          continue;
        }
        const double slope = std::tan(off_axis_rad);
        double nearest_m = 1.0;
        for (const double sign : {1.0, -1.0}) {
          const double t = 0.5 * (sign * slope / a + 2.0 * length_m);
          const double rest = 2.0 * length_m - t;
          const double rise = sign * a * (0.5 * t * t + t * rest - 0.5 * rest * rest);
          nearest_m =
              std::min(nearest_m, std::abs(std::abs(rise - length_m * slope) - std::abs(offset_m)));
          EXPECT_GE(t, -1e-12);
          EXPECT_GE(rest, -1e-12);
        }
        EXPECT_NEAR(nearest_m, 0.0, 1e-12) << length_m << ' ' << offset_m << ' ' << off_axis_rad;
      }
    }
  }
}

}  // namespace
}  // namespace tcert
