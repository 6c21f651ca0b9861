#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <tcert/speed_law.hpp>

namespace tcert {
namespace {

TEST(GatedSpeed, IsZeroWithoutMargin) {
  EXPECT_EQ(gated_speed({}, 0.0), 0.0);
  EXPECT_EQ(gated_speed({}, -0.1), 0.0);
  EXPECT_EQ(gated_speed({}, std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(GatedSpeed, FollowsTheSquashedMargin) {
  // beta m = 1: half way between 0.08 and 0.22.
  EXPECT_NEAR(gated_speed({}, 0.1), 0.15, 1e-15);
  // beta m = 0.25: a fifth of the way.
  EXPECT_NEAR(gated_speed({SpeedLawKind::squash, 0.08, 0.22, 5.0}, 0.05), 0.108, 1e-15);
  EXPECT_EQ(gated_speed({}, std::numeric_limits<double>::infinity()), 0.22);
}

TEST(GatedSpeed, NeverFallsAsTheMarginGrows) {
  double last = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const double v = gated_speed({}, 0.001 * k);
    EXPECT_GE(v, last);
    last = v;
  }
}

TEST(GatedSpeed, ClipsAndNeverHalts) {
  const SpeedLaw clip{SpeedLawKind::clip, 0.08, 0.22, 10.0};
  EXPECT_EQ(gated_speed(clip, -1.0), 0.08);
  EXPECT_EQ(gated_speed(clip, 0.0), 0.08);
  EXPECT_NEAR(gated_speed(clip, 0.05), 0.15, 1e-15);
  EXPECT_EQ(gated_speed(clip, 0.1), 0.22);
  EXPECT_EQ(gated_speed(clip, std::numeric_limits<double>::infinity()), 0.22);
  EXPECT_EQ(gated_speed(clip, -std::numeric_limits<double>::infinity()), 0.08);
  EXPECT_EQ(gated_speed(clip, std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(SpeedLaw, RefusesImpossibleValues) {
  EXPECT_THROW(validate(SpeedLaw{SpeedLawKind::squash, 0.3, 0.22, 10.0}), std::invalid_argument);
  EXPECT_THROW(validate(SpeedLaw{SpeedLawKind::squash, 0.0, 0.22, 10.0}), std::invalid_argument);
  EXPECT_THROW(validate(SpeedLaw{SpeedLawKind::squash, 0.08, 0.22, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace tcert
