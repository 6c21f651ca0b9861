#include <tcert/geometry.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace tcert {
namespace {

constexpr double kPi = std::numbers::pi;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST(WrappedAngle, HasTheBitsOfTheRemainder) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> near(-12.0, 12.0);
  for (int i = 0; i < 1'000'000; ++i) {
    const double angle = near(random);
    ASSERT_EQ(bits(wrapped_angle(angle)), bits(std::remainder(angle, 2.0 * kPi))) << angle;
  }
}

TEST(WrappedAngle, HasThemAtEveryEdge) {
  for (int half_turns = 0; half_turns < 12; ++half_turns) {
    const double edge = half_turns * kPi;
    for (const double angle : {edge, std::nextafter(edge, 0.0), std::nextafter(edge, 100.0)}) {
      for (const double signed_angle : {angle, -angle}) {
        EXPECT_EQ(bits(wrapped_angle(signed_angle)), bits(std::remainder(signed_angle, 2.0 * kPi)))
            << signed_angle;
      }
    }
  }
  EXPECT_TRUE(std::isnan(wrapped_angle(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(wrapped_angle(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace tcert
